#include <mpm_granular/transfer/apic.h>
#include <mpm_granular/transfer/sum_by_cell.h>

#include <algorithm>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  void
  Apic<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Gradient damping rate",
                      damping_rate,
                      "Part of the gradients that is found from the velocities "
                      "of the points alone, without their own gradients, per "
                      "time (MUSL only): steadies the points at the edge of a "
                      "body, but takes spin. Units: 1/s.",
                      Patterns::Double(0.));
  }

  template <int dim>
  std::vector<std::string>
  Apic<dim>::history_names() const
  {
    std::vector<std::string> names;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        names.push_back(std::string("velocity_gradient_") + "xyz"[i] +
                        "xyz"[j]);
    return names;
  }

  template <int dim>
  void
  Apic<dim>::initialize(Points::PointArrays<dim> &points,
                        const std::size_t         p,
                        const Tensor<2, dim>     &gradient) const
  {
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        points.history[this->first_slot + i * dim + j][p] = gradient[i][j];
  }

  template <int dim>
  double
  Apic<dim>::pic_factor(const double) const
  {
    return 1.;
  }

  template <int dim>
  void
  Apic<dim>::find_motion(const NodalVelocities<dim> &velocities,
                         const double                time_step,
                         Grid::NodalFields<dim>     &fields)
  {
    VelocityUpdate<dim>::find_motion(velocities, time_step, fields);
    kept      = 1. - std::min(1., damping_rate * time_step);
    increment = velocities.new_velocity;
    for (unsigned int i = 0; i < increment.size(); ++i)
      increment[i] -= kept * velocities.old_velocity[i];
  }

  template <int dim>
  void
  Apic<dim>::add_momentum(Grid::NodalFields<dim> &fields,
                          NodalVectors<dim>      &momentum) const
  {
    for (unsigned int i = 0; i < momentum.size(); ++i)
      momentum[i] += kept * fields.sums[i].momentum;
    fields.add_mass_times(increment, momentum);
  }

  template <int dim>
  void
  Apic<dim>::take(const PointBlock<dim>    &block,
                  Points::PointArrays<dim> &points) const
  {
    for (unsigned int r = 0; r < block.strained.size(); ++r)
      for (unsigned int p = block.strained[r].begin; p < block.strained[r].end;
           ++p)
        initialize(points, p, block.gradients[r]);
  }

  template <int dim>
  void
  Apic<dim>::give(const Mesh::BackgroundMesh<dim> &mesh,
                  const Points::PointArrays<dim>  &points,
                  const PointBlock<dim>           &block,
                  Grid::NodalFields<dim>          &fields) const
  {
    mesh.visit([&](const auto &cells) {
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      constexpr unsigned int n_nodes = Cell::n_nodes;
      using Momentum = std::array<std::array<double, n_nodes>, dim>;

      auto &active = fields.template cells<Cell>();
      sum_by_cell<Momentum>(
        block,
        [&](const unsigned int p, Momentum &sums) {
          if (points.cell[p] == Mesh::no_cell)
            return;
          const auto &nodes = cells[points.cell[p]].node;
          // The mean of the nodes is the point's place, up to a shape value
          // that relocate() has lifted: momentum stays exact.
          Tensor<1, dim> place;
          for (unsigned int k = 0; k < n_nodes; ++k)
            place += block.shape_values[k][p - block.begin] *
                     mesh.node_position(nodes[k]);
          for (unsigned int k = 0; k < n_nodes; ++k)
            {
              const Tensor<1, dim> arm = mesh.node_position(nodes[k]) - place;
              const double         weighted =
                points.mass[p] * block.shape_values[k][p - block.begin];
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int j = 0; j < dim; ++j)
                  sums[i][k] +=
                    weighted * arm[j] *
                    points.history[this->first_slot + i * dim + j][p];
            }
        },
        [&](const unsigned int cell, const Momentum &sums) {
          if (cell == Mesh::no_cell)
            return;
          auto &momentum = fields.sums_of(active, cell).momentum;
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int k = 0; k < n_nodes; ++k)
              momentum[d][k] += sums[d][k];
        });
    });
  }

  template class Apic<2>;
  template class Apic<3>;

  namespace
  {
    const std::string documentation =
      "PIC whose points also take over the gradient of the grid's velocity.";
    const VelocityUpdateRegistry<2>::Entry<Apic<2>> plane("APIC",
                                                          documentation);
    const VelocityUpdateRegistry<3>::Entry<Apic<3>> space("APIC",
                                                          documentation);
  } // namespace
} // namespace mpm_granular::Transfer
