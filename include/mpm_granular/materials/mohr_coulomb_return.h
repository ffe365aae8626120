#ifndef mpm_granular_materials_mohr_coulomb_return_h
#define mpm_granular_materials_mohr_coulomb_return_h

#include <mpm_granular/materials/coulomb_strength.h>
#include <mpm_granular/materials/elastic_moduli.h>
#include <mpm_granular/materials/perzyna_flow.h>

#include <array>

/*
 * The return to the planes of Mohr and Coulomb and those of the tension cut-off
 * in the space of principal stresses.
 */
namespace mpm_granular::Materials
{
  /// Principal stresses, the largest (of tension) first [Pa].
  using PrincipalStress = std::array<double, 3>;

  /// What the surfaces and the return to them depend on.
  struct MohrCoulombConstants
  {
    MohrCoulombConstants(const CoulombStrength &strength,
                         const ElasticModuli   &moduli);

    double sine;           ///< sin(phi)
    double dilatancy_sine; ///< sin(psi)
    double cohesion_term;  ///< 2 c cos(phi) [Pa]
    double tension;        ///< T [Pa]
    double bulk;           ///< K [Pa]
    double shear;          ///< G [Pa]

    /// Q = sigma_1 - sigma_3 [Pa].
    static double
    stress(const PrincipalStress &sigma)
    {
      return sigma[0] - sigma[2];
    }

    /// Y = 2 c cos(phi) - (sigma_1 + sigma_3) sin(phi) [Pa].
    double
    strength(const PrincipalStress &sigma) const
    {
      return cohesion_term - (sigma[0] + sigma[2]) * sine;
    }
  };

  /**
   * The stress at the end of a step of backward Euler (T54-T57).
   *
   * @param trial in descending order.
   * @return in descending order; not numbers if the trial has one.
   */
  PrincipalStress
  return_to_mohr_coulomb(const PrincipalStress      &trial,
                         const MohrCoulombConstants &constants,
                         const PerzynaStep          &step);
} // namespace mpm_granular::Materials

#endif
