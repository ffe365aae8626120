#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/output/points_output.h>
#include <mpm_granular/output/rows.h>
#include <mpm_granular/parameters/name_distance.h>

#include <algorithm>
#include <cmath>

namespace mpm_granular::Output
{
  using namespace dealii;

  namespace
  {
    /// q = sqrt(3/2 s:s) [Pa].
    template <int dim>
    double
    von_mises_stress(const Points::PointArrays<dim> &points,
                     const std::size_t               index)
    {
      const double p   = points.pressure(index);
      double       sum = 0.;
      for (unsigned int c = 0; c < n_stress<dim>; ++c)
        {
          const double stress = points.stress[c][index];
          sum += c < 3 ? (stress + p) * (stress + p) : 2. * stress * stress;
        }
      return std::sqrt(1.5 * sum);
    }



    template <int dim>
    double
    speed(const Points::PointArrays<dim> &points, const std::size_t index)
    {
      double square = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        square += points.velocity[d][index] * points.velocity[d][index];
      return std::sqrt(square);
    }



    /**
     * The slots of all laws by name. A name that several laws use is one field;
     * where a law does not have it, it is zero.
     */
    template <int dim>
    std::vector<Field>
    history_fields(const Points::PointArrays<dim> &points,
                   const Laws<dim>                &laws)
    {
      std::vector<std::string> names;
      for (const auto law : laws)
        for (const auto &name : law->history_names())
          if (std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);

      std::vector<Field> fields;
      for (const auto &name : names)
        {
          std::vector<int> slot_of_material;
          for (const auto law : laws)
            {
              const auto slots = law->history_names();
              const auto slot  = std::find(slots.begin(), slots.end(), name);
              slot_of_material.push_back(
                slot == slots.end() ? -1 : slot - slots.begin());
            }
          fields.push_back({name,
                            "",
                            1,
                            [&points, slot_of_material](const std::size_t i,
                                                        const unsigned int) {
                              const int slot =
                                slot_of_material[points.material[i]];
                              return slot < 0 ? 0. : points.history[slot][i];
                            }});
        }
      return fields;
    }
  } // namespace



  template <int dim>
  std::vector<Field>
  point_fields(const Points::PointArrays<dim> &points, const Laws<dim> &laws)
  {
    std::vector<Field> fields;
    const auto         add_scalar =
      [&](const std::string &name, const std::string &unit, auto value) {
        fields.push_back(
          {name, unit, 1, [value](const std::size_t i, const unsigned int) {
             return static_cast<double>(value(i));
           }});
      };

    fields.push_back({"velocity",
                      "m/s",
                      dim,
                      [&points](const std::size_t i, const unsigned int d) {
                        return points.velocity[d][i];
                      }});
    add_scalar("speed", "m/s", [&points](auto i) { return speed(points, i); });
    for (unsigned int c = 0; c < n_stress<dim>; ++c)
      add_scalar(std::string("stress_") + stress_name[c],
                 "Pa",
                 [&points, c](auto i) { return points.stress[c][i]; });
    add_scalar("pressure", "Pa", [&points](auto i) {
      return points.pressure(i);
    });
    add_scalar("von_mises_stress", "Pa", [&points](auto i) {
      return von_mises_stress(points, i);
    });
    add_scalar("volume_ratio", "", [&points, &laws](auto i) {
      return points.volume[i] * laws[points.material[i]]->density() /
             points.mass[i];
    });
    add_scalar("mass", dim == 2 ? "kg/m" : "kg", [&points](auto i) {
      return points.mass[i];
    });
    for (auto &field : history_fields(points, laws))
      fields.push_back(std::move(field));
    add_scalar("id", "", [&points](auto i) { return points.id[i]; });
    fields.back().is_natural = true;
    add_scalar("material", "", [&points](auto i) {
      return points.material[i];
    });
    fields.back().is_natural = true;
    return fields;
  }



  template <int dim>
  PointsOutput<dim>::PointsOutput(const OutputParameters &parameters,
                                  const Laws<dim>        &laws,
                                  const MPI_Comm          communicator)
    : parameters(parameters)
    , laws(laws)
    , series(parameters, "points", communicator)
  {
    (void)field_names();
  }



  template <int dim>
  std::vector<Field>
  PointsOutput<dim>::select(const std::vector<Field> &all) const
  {
    std::vector<bool> chosen(all.size(), false);
    for (const auto &wanted : parameters.point_fields)
      {
        bool found = false;
        for (unsigned int f = 0; f < all.size(); ++f)
          if (wanted == "all" || wanted == all[f].name ||
              (wanted == "stress" && all[f].name.rfind("stress_", 0) == 0))
            chosen[f] = found = true;
        if (!found)
          {
            std::vector<std::string> names{"all", "stress"};
            for (const auto &field : all)
              names.push_back(field.name);
            throw InputError(
              "Output/Point fields: there is no field '" + wanted + "'." +
              Parameters::did_you_mean(wanted, names) + " Valid names are " +
              Parameters::quoted_list(names) + ".");
          }
      }
    std::vector<Field> fields;
    for (unsigned int f = 0; f < all.size(); ++f)
      if (chosen[f])
        fields.push_back(all[f]);
    return fields;
  }



  template <int dim>
  void
  PointsOutput<dim>::write(const double                    time,
                           const unsigned int              step,
                           const Points::PointArrays<dim> &points)
  {
    // By their ids, so that they are the same at all times and on any number of
    // ranks.
    const unsigned int         stride = parameters.every_nth_point;
    std::vector<std::uint32_t> chosen;
    if (stride > 1)
      for (std::uint32_t i = 0; i < points.size(); ++i)
        if (points.id[i] % stride == 0)
          chosen.push_back(i);
    const auto index = [&](const std::size_t i) {
      return stride > 1 ? chosen[i] : i;
    };

    Contents<0, dim> contents;
    contents.n_items = contents.n_nodes =
      stride > 1 ? chosen.size() : points.size();
    contents.shape    = ReferenceCells::Vertex;
    contents.nodes    = [](const std::size_t i) { return ItemNodes<0>{i}; };
    contents.position = [&](const std::size_t i) {
      return points.location(index(i));
    };
    contents.fields = select(point_fields(points, laws));
    for (auto &field : contents.fields)
      field.value = [&index, value = field.value](const std::size_t  i,
                                                  const unsigned int c) {
        return value(index(i), c);
      };
    series.add(time, step, contents);
  }



  template <int dim>
  std::vector<std::string>
  PointsOutput<dim>::field_names() const
  {
    std::vector<std::string>       names;
    const Points::PointArrays<dim> none;
    for (const auto &field : select(point_fields(none, laws)))
      names.push_back(field.name);
    return names;
  }



  template <int dim>
  double
  PointsOutput<dim>::estimated_file_size(const std::size_t n_points) const
  {
    // Four bytes a number: position, fields, and the number of the point itself
    // as a cell, which in VTU files has an offset and a type of a byte, too.
    // The part that compression leaves was measured on the collapsing wall;
    // HDF5 sorts the bytes before.
    const bool                     is_hdf5 = parameters.format == "HDF5";
    const Points::PointArrays<dim> none;
    unsigned int                   n_numbers = n_directions + 1;
    for (const auto &field : select(point_fields(none, laws)))
      n_numbers += width_of(field);
    return n_points / parameters.every_nth_point *
           (4. * n_numbers + (is_hdf5 ? 0. : 5.)) *
           (parameters.compression == "none" ? 1. :
            is_hdf5                          ? 0.64 :
                                               0.69);
  }



  template std::vector<Field>
  point_fields(const Points::PointArrays<2> &, const Laws<2> &);
  template std::vector<Field>
  point_fields(const Points::PointArrays<3> &, const Laws<3> &);

  template class PointsOutput<2>;
  template class PointsOutput<3>;
} // namespace mpm_granular::Output
