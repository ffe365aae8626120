#ifndef mpm_granular_transfer_stress_power_h
#define mpm_granular_transfer_stress_power_h

#include <mpm_granular/core/stress_layout.h>
#include <mpm_granular/grid/nodal_fields.h>

#include <array>

namespace mpm_granular::Transfer
{
  /// A velocity gradient, row by row.
  template <int dim>
  using VelocityGradient = std::array<double, dim * dim>;

  /// The gradient of the straining velocity in a simplex.
  /// @param nodes slots of its nodes.
  template <int dim>
  inline VelocityGradient<dim>
  straining_gradient(
    const Mesh::SimplexCell<dim>                         &cell,
    const std::array<unsigned int, std::size_t(dim + 1)> &nodes,
    const Grid::NodalFields<dim>                         &fields)
  {
    VelocityGradient<dim> gradient{};
    const auto           &first = fields.motion[nodes[0]].straining;
    for (unsigned int k = 0; k < dim; ++k)
      {
        const auto &other = fields.motion[nodes[k + 1]].straining;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            gradient[i * dim + j] +=
              (other[i] - first[i]) * cell.gradient[k][j];
      }
    return gradient;
  }

  /// sigma : L.
  template <int dim>
  inline double
  stress_power(const Stress<dim> &stress, const VelocityGradient<dim> &gradient)
  {
    double power = 0.;
    for (unsigned int s = 0; s < n_stress<dim>; ++s)
      {
        const unsigned int i = stress_index[s][0], j = stress_index[s][1];
        if (i == j && i < dim)
          power += stress[s] * gradient[i * dim + i];
        else if (i < dim && j < dim)
          power += stress[s] * (gradient[i * dim + j] + gradient[j * dim + i]);
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
    return stress_power<dim>(sums.stress,
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
