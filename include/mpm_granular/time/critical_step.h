#ifndef mpm_granular_time_critical_step_h
#define mpm_granular_time_critical_step_h

#include <mpm_granular/mesh/box_cell.h>
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
   * The stability limit of a cell filled with an elastic medium, with lumped
   * mass (T24): 2/omega, omega^2 = n/rho times the largest eigenvalue of the
   * mean of B^T D B over the cell, where n is the number of its nodes [s].
   *
   * @param cell only its gradients are used.
   */
  template <class Cell>
  double
  critical_step(const Cell &cell, const WaveMedium &medium);
} // namespace mpm_granular::Time

#endif
