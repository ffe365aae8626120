#ifndef mpm_granular_transfer_stress_power_h
#define mpm_granular_transfer_stress_power_h

#include <mpm_granular/core/lanes.h>
#include <mpm_granular/core/stress_layout.h>
#include <mpm_granular/grid/nodal_fields.h>

#include <array>

namespace mpm_granular::Transfer
{
  /// A velocity gradient in lanes, column by column: in space a column is
  /// (dv_x/dx_j, dv_y/dx_j, dv_z/dx_j, 0), in the plane both stand in one.
  template <int dim>
  using VelocityGradient = std::array<Lanes, dim == 2 ? 1 : 3>;

  /// dv_i/dx_j.
  template <int dim>
  inline double
  derivative(const VelocityGradient<dim> &gradient,
             const unsigned int           i,
             const unsigned int           j)
  {
    if constexpr (dim == 2)
      return gradient[0].data[2 * j + i];
    else
      return gradient[j].data[i];
  }

  /// The gradient of the straining velocity in a simplex.
  /// @param nodes slots of its nodes.
  inline VelocityGradient<2>
  straining_gradient(const Mesh::SimplexCell<2>        &cell,
                     const std::array<unsigned int, 3> &nodes,
                     const Grid::NodalFields<2>        &fields)
  {
    const auto         &first    = fields.motion[nodes[0]].straining;
    VelocityGradient<2> gradient = {};
    for (unsigned int k = 0; k < 2; ++k)
      {
        const auto                &g = cell.gradient[k];
        const dealii::Tensor<1, 2> change =
          fields.motion[nodes[k + 1]].straining - first;
        gradient[0] += Lanes(change[0], change[1], change[0], change[1]) *
                       Lanes(g[0], g[0], g[1], g[1]);
      }
    return gradient;
  }

  inline VelocityGradient<3>
  straining_gradient(const Mesh::SimplexCell<3>        &cell,
                     const std::array<unsigned int, 4> &nodes,
                     const Grid::NodalFields<3>        &fields)
  {
    const auto velocity = [&](const unsigned int k) {
      return load<Lanes>(&fields.motion[nodes[k]].straining[0]);
    };
    const Lanes         first    = velocity(0);
    VelocityGradient<3> gradient = {};
    for (unsigned int k = 0; k < 3; ++k)
      {
        const Lanes change = velocity(k + 1) - first;
        for (unsigned int j = 0; j < 3; ++j)
          gradient[j] += change * cell.gradient[k][j];
      }
    return gradient;
  }

  /// sigma : L.
  /// @param stress gives component s in the order of n_stress.
  template <int dim, class StressComponent>
  inline double
  stress_power(StressComponent &&stress, const VelocityGradient<dim> &gradient)
  {
    double power = 0.;
    for (unsigned int s = 0; s < n_stress<dim>; ++s)
      {
        const unsigned int i = stress_index[s][0], j = stress_index[s][1];
        if (i == j && i < dim)
          power += stress(s) * derivative<dim>(gradient, i, i);
        else if (i < dim && j < dim)
          power += stress(s) * (derivative<dim>(gradient, i, j) +
                                derivative<dim>(gradient, j, i));
      }
    return power;
  }

  /// The power of the stresses of a cell's points on the straining velocities
  /// [W].
  /// @param nodes slots of the cell's nodes.
  template <int dim>
  inline double
  stress_power(const Grid::StressSums<Mesh::SimplexCell<dim>>       &sums,
               const Mesh::SimplexCell<dim>                         &cell,
               const std::array<unsigned int, std::size_t(dim + 1)> &nodes,
               const Grid::NodalFields<dim>                         &fields)
  {
    return stress_power<dim>([&](
                               const unsigned int s) { return sums.stress[s]; },
                             straining_gradient(cell, nodes, fields));
  }

  template <int dim>
  inline double
  stress_power(const Grid::StressSums<Mesh::BoxCell<dim>> &sums,
               const Mesh::BoxCell<dim> & /*cell*/,
               const std::array<unsigned int, std::size_t(1) << dim> &nodes,
               const Grid::NodalFields<dim>                          &fields)
  {
    double power = 0.;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      for (unsigned int d = 0; d < dim; ++d)
        power -= sums.force[d][k] * fields.motion[nodes[k]].straining[d];
    return power;
  }
} // namespace mpm_granular::Transfer

#endif
