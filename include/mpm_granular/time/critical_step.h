#ifndef mpm_granular_time_critical_step_h
#define mpm_granular_time_critical_step_h

#include <mpm_granular/mesh/simplex_cell.h>

namespace mpm_granular::Time
{
  /// What the stability of a step depends on in a material.
  struct WaveMedium
  {
    double bulk_modulus;  ///< [Pa]
    double shear_modulus; ///< [Pa]
    double density;       ///< [kg/m^3]
  };

  /**
   * The stability limit of a simplex filled with an elastic medium, with lumped
   * mass (T24): 2/omega, omega^2 = (dim+1)/rho times the largest eigenvalue of
   * B^T D B [s].
   */
  template <int dim>
  double
  critical_step(const Mesh::SimplexCell<dim> &cell, const WaveMedium &medium);
} // namespace mpm_granular::Time

#endif
