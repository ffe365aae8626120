#include <mpm_granular/core/lanes.h>
#include <mpm_granular/parameters/pattern_text.h>
#include <mpm_granular/transfer/position_shift.h>

#include <algorithm>
#include <cmath>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  void
  PositionShift<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Position shift rate",
                      given_rate,
                      "Rate at which points move from where they are too many "
                      "to where there is room, for flows with few points per "
                      "cell (with 'Averaging = nodes' only). 0: never. "
                      "'automatic': 10/s for granular laws with means around "
                      "nodes and fewer than 3 points per filled cell at the "
                      "start, else 0. Units: 1/s.",
                      Parameters::AutomaticNumber());
  }

  template <int dim>
  double
  PositionShift<dim>::rate(const double automatic) const
  {
    return Parameters::AutomaticNumber::value_of(given_rate, automatic);
  }

  template <int dim>
  Tensor<1, dim>
  PositionShift<dim>::add(const Mesh::BackgroundMesh<dim>      &mesh,
                          const Mesh::Partition<dim>           &partition,
                          const double                          rate,
                          const Filling<dim>                   &filling,
                          const std::vector<double>            &cell_sizes,
                          const Grid::VelocityConstraints<dim> &constraints,
                          const double                          time_step,
                          Grid::NodalFields<dim>               &fields) const
  {
    using Cell = Mesh::SimplexCell<dim>;

    // In a step, of the size of a cell.
    constexpr double furthest = 0.01;

    const auto         &cells  = mesh.template cells<Cell>();
    const auto         &active = fields.template cells<Cell>();
    std::vector<double> excess(fields.n_active_nodes());
    for (unsigned int i = 0; i < excess.size(); ++i)
      excess[i] = std::max(filling.fraction(fields, i) - 1., 0.);
    fields.hanging.extend(excess);

    const double fastest = furthest / time_step;

    // Means over the cells around the nodes: sums, and in the last lane their
    // weights.
    std::vector<std::array<Lanes, 1>> shifts(fields.n_active_nodes());
    for (unsigned int c = 0; c < fields.active_cells.size(); ++c)
      {
        const unsigned int index = fields.active_cells[c];
        if (!partition.is_owned(index))
          continue;
        const Cell &cell  = cells[index];
        const auto &nodes = active.nodes[c];
        Lanes       slope = 0.;
        for (unsigned int k = 0; k < dim; ++k)
          {
            const auto &g = cell.gradient[k];
            slope += (excess[nodes[k + 1]] - excess[nodes[0]]) *
                     Lanes(g[0], g[1], g[dim - 1], 0.);
          }

        const double volume  = mesh.cell_volume(index);
        const double size    = cell_sizes[index];
        const Lanes  shift   = -rate * size * size * slope;
        const Lanes  largest = fastest * size;
        const Lanes  clamped =
          0. - minimum(0. - minimum(shift, largest), largest);
        std::array<Lanes, 1> part  = {{volume * clamped}};
        part[0].data[Lanes::n - 1] = volume;
        for (const unsigned int node : nodes)
          fields.hanging.add_at(shifts, node, part);
      }
    fields.shared.sum(shifts);

    std::vector<Tensor<1, dim>> velocity(shifts.size());
    for (unsigned int i = 0; i < velocity.size(); ++i)
      {
        const auto  &sums   = shifts[i][0].data;
        const double volume = sums[Lanes::n - 1];
        if (volume > 0.)
          for (unsigned int d = 0; d < dim; ++d)
            velocity[i][d] = sums[d] / volume;
      }
    constraints.project(velocity);

    Tensor<1, dim> moved;
    for (unsigned int i = 0; i < velocity.size(); ++i)
      {
        fields.motion[i].velocity += velocity[i];
        if (fields.shared.counts(i))
          moved += fields.sums[i].mass * velocity[i];
      }
    return moved;
  }

  template class PositionShift<2>;
  template class PositionShift<3>;
} // namespace mpm_granular::Transfer
