#ifndef mpm_granular_grid_cell_sums_h
#define mpm_granular_grid_cell_sums_h

#include <mpm_granular/core/stress_layout.h>

#include <array>

namespace mpm_granular::Grid
{
  /**
   * What the points of a simplex contribute to the grid, summed over the points
   * (T9). Nodal values follow from it: masses are the row sums of the mass
   * matrix, and the internal force on node i is -stress . grad N_i, because the
   * gradients are constant in a cell.
   */
  template <int dim>
  struct CellSums
  {
    static constexpr unsigned int n_nodes = dim + 1;

    /// Consistent mass matrix sum_p m_p N_i N_j, full storage [kg].
    std::array<double, n_nodes * n_nodes> mass;

    /// Momentum sum_p m_p N_i v_p, components first [kg m/s].
    std::array<std::array<double, n_nodes>, dim> momentum;

    /// sum_p V_p sigma_p [J].
    Stress<dim> stress;
  };
} // namespace mpm_granular::Grid

#endif
