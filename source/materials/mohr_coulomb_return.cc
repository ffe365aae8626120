#include <deal.II/base/numbers.h>

#include <mpm_granular/materials/mohr_coulomb_corners.h>
#include <mpm_granular/materials/mohr_coulomb_return.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace mpm_granular::Materials
{
  MohrCoulombConstants::MohrCoulombConstants(const CoulombStrength &strength,
                                             const ElasticModuli   &moduli)
    : tension(strength.tensile_strength())
    , bulk(moduli.bulk())
    , shear(moduli.shear())
  {
    const double degree = dealii::numbers::PI / 180.;
    sine                = std::sin(strength.friction_angle() * degree);
    dilatancy_sine      = std::sin(strength.dilatancy_angle() * degree);
    cohesion_term =
      2. * strength.cohesion() * std::cos(strength.friction_angle() * degree);
  }



  namespace
  {
    using Constants = MohrCoulombConstants;

    bool
    is_in_order(const PrincipalStress &sigma)
    {
      return sigma[0] >= sigma[1] && sigma[1] >= sigma[2];
    }



    /// Dilatancy of the multiplier 1 takes this off each stress [Pa].
    double
    drop_by_dilatancy(const Constants &constants)
    {
      return 2. * (constants.bulk - 2. / 3. * constants.shear) *
             constants.dilatancy_sine;
    }



    /// The return to the plane of the largest and the least stress (T55); none
    /// if that is not the solution.
    std::optional<PrincipalStress>
    return_to_plane(const PrincipalStress &trial,
                    const Constants       &constants,
                    const PerzynaStep     &step)
    {
      const double G = constants.shear, K = constants.bulk,
                   s = constants.dilatancy_sine;
      const double lambda =
        flow_multiplier({constants.stress(trial),
                         constants.strength(trial),
                         4. * G,
                         4. * constants.sine * s * (K + G / 3.)},
                        step);
      const double    common = drop_by_dilatancy(constants) * lambda;
      PrincipalStress sigma{{trial[0] - 2. * G * (1. + s) * lambda - common,
                             trial[1] - common,
                             trial[2] + 2. * G * (1. - s) * lambda - common}};
      if (is_in_order(sigma) && sigma[0] <= constants.tension)
        return sigma;
      return {};
    }



    /**
     * The return to an edge of the pyramid, where two stresses are equal (T56);
     * none if that is not the solution.
     *
     * @param is_compression the two larger stresses are equal, as in triaxial
     *   compression; otherwise the two smaller ones.
     */
    std::optional<PrincipalStress>
    return_to_edge(const PrincipalStress &trial,
                   const Constants       &constants,
                   const PerzynaStep     &step,
                   const bool             is_compression)
    {
      const double G = constants.shear, K = constants.bulk,
                   s    = constants.dilatancy_sine;
      const double sign = is_compression ? 1. : -1.;
      // The two that become equal, and the third one.
      const double first  = is_compression ? trial[0] : trial[1];
      const double second = is_compression ? trial[1] : trial[2];
      const double mean   = .5 * (first + second);
      const double third  = is_compression ? trial[2] : trial[0];

      const double lambda =
        flow_multiplier({sign * (mean - third),
                         constants.cohesion_term -
                           (mean + third) * constants.sine,
                         G * (3. - sign * s),
                         constants.sine * (s * (4. * K + G / 3.) - sign * G)},
                        step);
      // The multipliers of both planes must not be negative.
      if (!(lambda * 2. * G * (1. + sign * s) >=
            (first - second) * (1. - 1e-12)))
        return {};
      const double common = drop_by_dilatancy(constants) * lambda;
      const double pair   = mean - sign * G * (1. + sign * s) * lambda - common;
      const double other =
        third + sign * 2. * G * (1. - sign * s) * lambda - common;
      const PrincipalStress sigma = is_compression ?
                                      PrincipalStress{{pair, pair, other}} :
                                      PrincipalStress{{other, pair, pair}};
      if (is_in_order(sigma) && sigma[0] <= constants.tension)
        return sigma;
      return {};
    }



    /**
     * Whether the return ends at tension on all sides (T57b): the elastic
     * strain from there can be made up of the directions of the planes that
     * meet there, those of tension, and at the apex those of Mohr and Coulomb.
     */
    bool
    is_separated(const PrincipalStress &trial, const Constants &constants)
    {
      const double T = constants.tension;
      const double volumetric =
        (trial[0] + trial[1] + trial[2] - 3. * T) *
        (1. - 2. / 3. * constants.shear / constants.bulk) / 3.;
      double extension = 0., shortening = 0.; // times 2 G
      for (const double sigma : trial)
        {
          const double strain = sigma - T - volumetric;
          extension += std::max(strain, 0.);
          shortening += std::max(-strain, 0.);
        }
      const bool is_apex = constants.cohesion_term - 2. * T * constants.sine <=
                           1e-12 * constants.cohesion_term;
      return is_apex ? extension * (1. - constants.dilatancy_sine) >=
                         shortening * (1. + constants.dilatancy_sine) :
                       shortening == 0.;
    }



    PrincipalStress
    tension_on_all_sides(const Constants &constants)
    {
      return {{constants.tension, constants.tension, constants.tension}};
    }
  } // namespace



  PrincipalStress
  return_to_mohr_coulomb(const PrincipalStress      &trial,
                         const MohrCoulombConstants &constants,
                         const PerzynaStep          &step)
  {
    if (std::isnan(trial[0] + trial[1] + trial[2]))
      return trial;
    if (trial[0] <= constants.tension &&
        constants.stress(trial) <= constants.strength(trial))
      return trial;

    if (is_separated(trial, constants))
      return tension_on_all_sides(constants);

    if (constants.stress(trial) > constants.strength(trial))
      {
        if (const auto sigma = return_to_plane(trial, constants, step))
          return *sigma;
        for (const bool is_compression : {true, false})
          if (const auto sigma =
                return_to_edge(trial, constants, step, is_compression))
            return *sigma;
      }
    const PrincipalStress sigma = return_to_corner(trial, constants, step);
    const bool            is_at_corner =
      sigma[2] >= constants.tension - 1e-10 * constants.stress(trial);
    return is_at_corner ? tension_on_all_sides(constants) : sigma;
  }
} // namespace mpm_granular::Materials
