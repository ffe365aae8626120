#include <mpm_granular/transfer/filling.h>
#include <mpm_granular/transfer/point_groups.h>

#include <algorithm>
#include <type_traits>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  void
  Filling<dim>::reinit(const Mesh::BackgroundMesh<dim> &new_mesh,
                       const Mesh::Partition<dim>      &new_partition,
                       const std::vector<double>       &new_largest)
  {
    mesh      = &new_mesh;
    partition = &new_partition;
    mesh->visit([&](const auto &cells) {
      n_nodes = std::decay_t<decltype(cells)>::value_type::n_nodes;
    });
    largest_specific_volume = new_largest;
    clear();
  }

  template <int dim>
  template <class Cell>
  void
  Filling<dim>::add_in(const Points::PointArrays<dim> &points,
                       const PointBlock<dim>          &block,
                       const Grid::NodalFields<dim>   &fields)
  {
    constexpr unsigned int n_nodes = Cell::n_nodes;
    parts.resize(fields.active_cells.size() * n_nodes);
    const double *volume       = points.volume.data();
    const double *mass         = points.mass.data();
    const auto    shape_values = pointers(block.shape_values);
    for (const auto &part : block.parts)
      {
        if (part.cell == Mesh::no_cell)
          continue;
        const unsigned int end = part.points.end;
        const double       largest =
          largest_specific_volume[points.material[part.points.begin]];
        Lanes sums[n_nodes]{};
        for_each_group(part.points,
                       points.size(),
                       [&](const auto type, const auto p) {
                         using Number = std::decay_t<decltype(type)>;
                         const Number filled =
                           first_of(minimum(load<Number>(volume + p),
                                            load<Number>(mass + p) * largest),
                                    end - p);
                         for (unsigned int k = 0; k < n_nodes; ++k)
                           accumulate(sums[k],
                                      filled * load<Number>(shape_values[k] +
                                                            p - block.begin));
                       });
        double *total = parts.data() + fields.slot_of_cell(part.cell) * n_nodes;
        for (unsigned int k = 0; k < n_nodes; ++k)
          total[k] += sum_of(sums[k]);
      }
  }

  template <int dim>
  void
  Filling<dim>::add(const Points::PointArrays<dim> &points,
                    const PointBlock<dim>          &block,
                    const Grid::NodalFields<dim>   &fields)
  {
    mesh->visit([&](const auto &cells) {
      add_in<typename std::decay_t<decltype(cells)>::value_type>(points,
                                                                 block,
                                                                 fields);
    });
  }

  template <int dim>
  void
  Filling<dim>::sum(Grid::NodalFields<dim> &fields)
  {
    parts.resize(fields.active_cells.size() * n_nodes);
    fields.find_shared_cells(parts, n_nodes);

    fractions.assign(fields.n_active_nodes(), 0.);
    mesh->visit([&](const auto &cells) {
      using Cell         = typename std::decay_t<decltype(cells)>::value_type;
      const auto &active = fields.template cells<Cell>();
      for (unsigned int c = 0; c < fields.active_cells.size(); ++c)
        if (partition->is_owned(fields.active_cells[c]))
          for (unsigned int k = 0; k < Cell::n_nodes; ++k)
            fields.hanging.add_at(fractions,
                                  active.nodes[c][k],
                                  parts[c * n_nodes + k]);
    });
    fields.shared.sum(fractions.data(), 1);
    for (unsigned int i = 0; i < fractions.size(); ++i)
      fractions[i] /= mesh->node_volume(fields.active_nodes[i]);
  }

  template <int dim>
  std::vector<std::uint8_t>
  Filling<dim>::full_nodes(const Grid::NodalFields<dim> &fields) const
  {
    std::vector<std::uint8_t> result(fractions.size() + fields.hanging.size());
    for (unsigned int i = 0; i < result.size(); ++i)
      result[i] = fraction(fields, i) > full;
    return result;
  }

  template <int dim>
  void
  Filling<dim>::serialize(Core::Archive &archive)
  {
    archive.distributed("filling/volumes", parts, n_nodes);
  }

  template class Filling<2>;
  template class Filling<3>;
} // namespace mpm_granular::Transfer
