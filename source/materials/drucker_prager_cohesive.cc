#include <mpm_granular/materials/drucker_prager_cohesive.h>
#include <mpm_granular/materials/drucker_prager_parameters.h>

#include <cmath>
#include <limits>

namespace mpm_granular::Materials
{
  using namespace dealii;

  template <int dim>
  DruckerPragerCohesive<dim>::DruckerPragerCohesive()
  {
    set_slopes();
  }



  template <int dim>
  void
  DruckerPragerCohesive<dim>::set_slopes()
  {
    friction_slope = slope_of_cone(cone_slope_rule, strength.friction_angle());
    dilatancy_slope =
      slope_of_cone(cone_slope_rule, strength.dilatancy_angle());
  }



  template <int dim>
  void
  DruckerPragerCohesive<dim>::add_parameters(ParameterHandler &prm)
  {
    GranularLaw<dim>::add_parameters(prm);
    strength.add_parameters(prm);
    add_cone_slope(prm, cone_slope_rule);
    perzyna.add_parameters(prm);
    for (const std::string entry :
         {"Friction angle", "Dilatancy angle", "Cone slope"})
      prm.add_action(entry, [this](const std::string &) { set_slopes(); });
  }



  template <int dim>
  void
  DruckerPragerCohesive<dim>::check() const
  {
    GranularLaw<dim>::check();
    strength.check();
  }



  template <int dim>
  void
  DruckerPragerCohesive<dim>::flow(
    typename GranularLaw<dim>::Stresses &stresses) const
  {
    const PerzynaStep step    = perzyna.over(stresses.time_step);
    const double      bulk    = this->moduli.bulk();
    const double      drop    = 3. * this->moduli.shear();
    const double      tension = strength.tensile_strength();
    const double      m = friction_slope, beta = dilatancy_slope;
    const auto        yield = [&](const double pressure) {
      return m * (pressure + strength.apex_tension());
    };

    // q / q_tr; without strength 0, not the round-off of a difference.
    const double negligible = 1e-12 * this->moduli.shear();
    const auto   factor     = [&](const double q_tr,
                            const double lambda,
                            const double strength_at_end) {
      return strength_at_end <= negligible ? 0. : 1. - drop * lambda / q_tr;
    };

    for (unsigned int i = 0; i < stresses.n_points; ++i)
      {
        const double q_tr =
          std::sqrt(equivalent_stress_square(stresses.deviator_of(i)));
        double &pressure = stresses.pressure[i];
        if (pressure < -tension)
          {
            // On the cap, unless dilation alone takes the stress off it.
            const double at_cap = yield(-tension);
            const double lambda =
              q_tr > at_cap ? flow_multiplier({q_tr, at_cap, drop, 0.}, step) :
                              0.;
            const double opening = (-tension - pressure) / bulk - beta * lambda;
            if (opening >= 0.)
              {
                pressure            = -tension;
                stresses.opening[i] = opening;
                if (lambda > 0.)
                  stresses.scale_deviator(i, factor(q_tr, lambda, at_cap));
                continue;
              }
          }
        else if (q_tr <= yield(pressure))
          continue;
        const double lambda =
          flow_multiplier({q_tr, yield(pressure), drop, m * beta * bulk}, step);
        pressure += bulk * beta * lambda;
        stresses.scale_deviator(i, factor(q_tr, lambda, yield(pressure)));
      }
  }



  template <int dim>
  double
  DruckerPragerCohesive<dim>::mobilization(const Stress<dim> &stress) const
  {
    const double p = pressure(stress), q = equivalent_stress(stress);
    if (p < -strength.tensile_strength())
      return std::numeric_limits<double>::infinity();
    return q > 0. ? q / (friction_slope * (p + strength.apex_tension())) : 0.;
  }

  template class DruckerPragerCohesive<2>;
  template class DruckerPragerCohesive<3>;

  namespace
  {
    const std::string documentation =
      "the cone of Drucker and Prager with cohesion, dilatancy and tensile "
      "strength, Perzyna's flow or rate-independent.";
    const LawRegistry<2>::Entry<DruckerPragerCohesive<2>>
      cohesive_2d("Drucker-Prager cohesive", documentation);
    const LawRegistry<3>::Entry<DruckerPragerCohesive<3>>
      cohesive_3d("Drucker-Prager cohesive", documentation);
  } // namespace
} // namespace mpm_granular::Materials
