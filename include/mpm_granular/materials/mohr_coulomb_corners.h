#ifndef mpm_granular_materials_mohr_coulomb_corners_h
#define mpm_granular_materials_mohr_coulomb_corners_h

#include <mpm_granular/materials/mohr_coulomb_return.h>

namespace mpm_granular::Materials
{
  /**
   * The return to wherever planes of Mohr and Coulomb and of the tension
   * cut-off meet, by trying the sets of active planes: for all that the closed
   * forms of return_to_mohr_coulomb() do not hold for. In Perzyna's form the
   * factor on the stress, 1/(1 + x), is found by bracketing (T57a).
   *
   * @param trial outside of the surface, in descending order.
   */
  PrincipalStress
  return_to_corner(const PrincipalStress      &trial,
                   const MohrCoulombConstants &constants,
                   const PerzynaStep          &step);
} // namespace mpm_granular::Materials

#endif
