#ifndef mpm_granular_grid_cell_sums_h
#define mpm_granular_grid_cell_sums_h

#include <mpm_granular/core/stress_layout.h>
#include <mpm_granular/mesh/box_cell.h>
#include <mpm_granular/mesh/simplex_cell.h>

#include <array>

namespace mpm_granular::Grid
{
  /// What the internal forces of the nodes of a cell follow from, summed over
  /// its points (T9).
  template <class Cell>
  struct StressSums;

  /// In a simplex gradients are constant: -stress . grad N_i is the force on
  /// node i.
  template <int dim>
  struct StressSums<Mesh::SimplexCell<dim>>
  {
    /// sum_p V_p sigma_p [J].
    Stress<dim> stress;

    void
    operator+=(const StressSums &other)
    {
      for (unsigned int s = 0; s < n_stress<dim>; ++s)
        stress[s] += other.stress[s];
    }
  };

  /// In a box gradients depend on the place, so that forces are summed.
  template <int dim>
  struct StressSums<Mesh::BoxCell<dim>>
  {
    /// -sum_p V_p sigma_p . grad N_i(x_p), components first [N].
    std::array<std::array<double, Mesh::BoxCell<dim>::n_nodes>, dim> force;

    void
    operator+=(const StressSums &other)
    {
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int k = 0; k < force[d].size(); ++k)
          force[d][k] += other.force[d][k];
    }
  };

  /**
   * What the points of a cell contribute to the grid, summed over the points
   * (T9). Nodal values follow from it: masses are the row sums of the mass
   * matrix.
   */
  template <class Cell>
  struct CellSums
  {
    static constexpr unsigned int n_nodes = Cell::n_nodes;

    /// Consistent mass matrix sum_p m_p N_i N_j, full storage [kg].
    std::array<double, n_nodes * n_nodes> mass;

    /// Momentum sum_p m_p N_i v_p, components first [kg m/s].
    std::array<std::array<double, n_nodes>, Cell::dim> momentum;

    StressSums<Cell> internal;
  };
} // namespace mpm_granular::Grid

#endif
