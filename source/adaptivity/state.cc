#include <deal.II/base/mpi.h>

#include <mpm_granular/adaptivity/state.h>

#include <algorithm>
#include <cmath>

namespace mpm_granular::Adaptivity
{
  using namespace dealii;

  template <int dim>
  State<dim>::State(const Mesh::BackgroundMesh<dim>  &mesh,
                    const Mesh::Partition<dim>       &partition,
                    const Grid::NodalFields<dim>     &fields,
                    const std::vector<std::uint32_t> &n_points,
                    const double                      time)
    : mesh(mesh)
    , partition(partition)
    , fields(fields)
    , time(time)
    , touching(mesh)
    , points_of_cells(n_points.begin(), n_points.end())
  {
    AssertDimension(n_points.size(), mesh.n_cells());
    send_to_ghosts(points_of_cells);
  }

  template <int dim>
  double
  State<dim>::size(const unsigned int cell) const
  {
    return mesh.size_of_cell(mesh.cell_volume(cell));
  }

  template <int dim>
  Tensor<1, dim>
  State<dim>::velocity(const unsigned int node) const
  {
    if (const auto *mean = mesh.hanging_nodes().get_constraint_entries(node))
      {
        Tensor<1, dim> sum;
        for (const auto &[free, weight] : *mean)
          sum += weight * velocity(free);
        return sum;
      }
    const auto &sums = fields.sums[fields.slot_of(node)];
    return sums.momentum / sums.mass;
  }

  template <int dim>
  Tensor<2, dim>
  State<dim>::velocity_gradient(const unsigned int cell) const
  {
    Tensor<2, dim> gradient;
    if (n_points(cell) > 0)
      mesh.visit([&](const auto &cells) {
        for (unsigned int k = 0; k < cells[cell].node.size(); ++k)
          gradient += outer_product(velocity(cells[cell].node[k]),
                                    cells[cell].central_gradient(k));
      });
    return gradient;
  }

  template <int dim>
  double
  State<dim>::largest_speed() const
  {
    double largest = 0.;
    for (const unsigned int node : fields.active_nodes)
      if (fields.sums[fields.slot_of(node)].mass > 0.)
        largest = std::max(largest, velocity(node).norm());
    return Utilities::MPI::max(largest, partition.communicator);
  }

  template <int dim>
  void
  State<dim>::send_to_ghosts(std::vector<unsigned int> &values) const
  {
    mesh.template send_to_ghosts<unsigned int>(
      [&](const unsigned int cell) { return values[cell]; },
      [&](const unsigned int cell, const unsigned int &value) {
        values[cell] = value;
      });
  }

  template class State<2>;
  template class State<3>;
} // namespace mpm_granular::Adaptivity
