#ifndef tests_adaptivity_state_on_box_h
#define tests_adaptivity_state_on_box_h

#include <deal.II/base/mpi.h>

#include "../box_mesh.h"

#include <mpm_granular/adaptivity/adaptation.h>
#include <mpm_granular/parameters/parameter_file.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <memory>
#include <set>

namespace Test
{
  /// What criteria look at, on the unit box in n cells a side.
  template <int dim>
  struct StateOnBox
  {
    Mesh::BackgroundMesh<dim>               mesh;
    Mesh::Partition<dim>                    partition;
    Grid::NodalFields<dim>                  fields;
    std::unique_ptr<Adaptivity::State<dim>> state;

    StateOnBox(const Mesh::MeshSource<dim> &source,
               const MPI_Comm               communicator = MPI_COMM_WORLD)
      : mesh(source, "", communicator)
      , partition({}, mesh, communicator)
      , fields(mesh, partition)
    {
      set_points([](const Point<dim> &) { return 0; });
    }

    Point<dim>
    center(const unsigned int cell) const
    {
      const auto nodes = mesh.nodes(cell);
      Point<dim> sum;
      for (const unsigned int node : nodes)
        sum += mesh.node_position(node) / double(nodes.size());
      return sum;
    }

    /// Puts so many points into the cells with such centres, as
    /// MaterialPoints::count_by_cell() counts them; nodes have the mass 2 and
    /// such velocities.
    void
    set_points(
      const std::function<unsigned int(const Point<dim> &)>   &number_at,
      const std::function<Tensor<1, dim>(const Point<dim> &)> &velocity =
        [](const Point<dim> &) { return Tensor<1, dim>(); },
      const double time = 0.)
    {
      std::vector<std::uint32_t> n_points(mesh.n_cells(), 0);
      fields.clear_cells();
      for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
        {
          if (!mesh.is_distributed() || partition.is_owned(cell))
            n_points[cell] = number_at(center(cell));
          if (n_points[cell] > 0 && partition.is_owned(cell))
            fields.activate(cell);
        }
      fields.gather_nodes();
      for (const unsigned int node : fields.active_nodes)
        {
          auto &sums    = fields.sums[fields.slot_of(node)];
          sums.mass     = 2.;
          sums.momentum = 2. * velocity(mesh.node_position(node));
        }
      state = std::make_unique<Adaptivity::State<dim>>(
        mesh, partition, fields, n_points, time);
    }

    /// How many cells, over all ranks, have each level, and where: the sum of
    /// their centres' first coordinates.
    std::string
    report(const std::function<unsigned int(const unsigned int)> &level) const
    {
      std::vector<double> numbers(5, 0.), places(5, 0.);
      for (unsigned int cell = 0; cell < mesh.n_own_cells(); ++cell)
        if (partition.is_owned(cell))
          {
            const unsigned int l = std::min(level(cell), 4u);
            numbers[l] += 1.;
            places[l] += center(cell)[0];
          }
      Utilities::MPI::sum(numbers, partition.communicator, numbers);
      Utilities::MPI::sum(places, partition.communicator, places);
      std::ostringstream text;
      for (unsigned int l = 1; l < numbers.size(); ++l)
        if (numbers[l] > 0.)
          text << ", " << numbers[l] << " want " << l << " around x = "
               << std::round(1e6 * places[l] / numbers[l]) / 1e6;
      return text.str();
    }

    /// The same for a criterion.
    std::string
    ask(const std::string &type, const std::vector<std::string> &entries) const
    {
      const auto criterion = Adaptivity::CriterionRegistry<dim>::make(type);
      Parameters::read(*criterion, "", entries);
      criterion->check();
      criterion->prepare(*state);
      return report([&](const unsigned int cell) {
        return criterion->wanted_level(*state, cell);
      });
    }

    /// The same for the whole adaptation.
    std::string
    adapt(const std::vector<std::string> &entries) const
    {
      Adaptivity::AdaptationParameters<dim> parameters;
      Parameters::read(parameters, "", entries);
      parameters.check();
      Adaptivity::Adaptation<dim> adaptation(parameters);
      const auto                  levels = adaptation.wanted_levels(*state);
      // Ghosts are told what their owners say.
      std::vector<unsigned int> of_owners(levels.begin(), levels.end());
      state->send_to_ghosts(of_owners);
      const bool agree =
        std::equal(levels.begin(), levels.end(), of_owners.begin());
      const std::string text =
        report([&](const unsigned int cell) { return levels[cell]; });
      return text + (adaptation.is_limited() ? ", limited" : "") +
             (Utilities::MPI::min(agree ? 1 : 0, partition.communicator) ?
                "" :
                ", GHOSTS DIFFER");
    }
  };

  /// Prints on one rank.
  inline void
  print(const std::string &text)
  {
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << text << std::endl;
  }
} // namespace Test

#endif
