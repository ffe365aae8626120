#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/patterns.h>

#include <mpm_granular/materials/drucker_prager_parameters.h>
#include <mpm_granular/parameters/documentation_handler.h>
#include <mpm_granular/parameters/pattern_text.h>

#include <cmath>
#include <limits>

namespace mpm_granular::Materials
{
  using namespace dealii;

  namespace
  {
    /// Slope m of the cone (T5) [-]. @param angle friction angle [degrees].
    double
    slope_of_cone(const std::string &rule, const double angle)
    {
      const double sine = std::sin(angle * numbers::PI / 180.);
      if (rule == "triaxial compression")
        return 6. * sine / (3. - sine);
      if (rule == "triaxial extension")
        return 6. * sine / (3. + sine);
      if (rule == "plane strain")
        return std::sqrt(3.) * sine;
      Assert(rule == "paper", ExcInternalError());
      return 18. * sine / (9. - sine * sine);
    }
  } // namespace



  DruckerPragerParameters::DruckerPragerParameters()
  {
    set_coefficients();
  }



  void
  DruckerPragerParameters::set_coefficients()
  {
    slope = slope_of_cone(cone_slope_rule, friction_angle);
    log_volume_ratio_limit =
      separation_rule == "reset"  ? 0. :
      separation_rule == "capped" ? log_volume_ratio_cap :
                                    std::numeric_limits<double>::infinity();
  }



  void
  DruckerPragerParameters::add_parameters(ParameterHandler &prm)
  {
    using Parameters::positive_number;
    prm.add_parameter("Density",
                      initial_density,
                      "Mass per volume, pores included, at zero stress. Units: "
                      "kg/m^3.",
                      positive_number());
    elastic_moduli.add_parameters(prm);
    prm.add_parameter("Friction angle",
                      friction_angle,
                      "Angle of internal friction. Units: degrees.",
                      positive_number(89.));
    prm.add_parameter(
      "Cone slope",
      cone_slope_rule,
      "What the slope m of the cone q = m p is fitted to, with the sine S of "
      "the friction angle. 'paper': m = 18 S/(9 - S^2), the mean of the next "
      "two. 'triaxial compression': m = 6 S/(3 - S). 'triaxial extension': "
      "m = 6 S/(3 + S). 'plane strain': m = sqrt(3) S, so that the friction in "
      "plane flow at constant volume is that of the friction angle.",
      Patterns::Selection(
        "paper|triaxial compression|triaxial extension|plane strain"));
    prm.add_parameter("Fluidity",
                      flow_fluidity,
                      "Factor gamma of the viscoplastic flow, whose equivalent "
                      "rate is gamma ((q - m p)/(m p))^N. The larger, the "
                      "closer to rate-independent plasticity. Units: 1/s.",
                      positive_number());
    prm.add_parameter("Perzyna exponent",
                      perzyna_exponent,
                      "Exponent N of the viscoplastic flow, at least 0.05. A "
                      "large N is not the rate-independent limit: the stress "
                      "then reaches up to twice the friction.",
                      Patterns::Double(0.05, 100.));
    prm.add_parameter(
      "Separation",
      separation_rule,
      "What becomes of the volume ratio of a point that is larger than without "
      "stress. 'track': it is kept, the gap must close before pressure "
      "returns. 'reset': it is forgotten, pressure returns at once; the volume "
      "grows with every opening. 'capped': it is kept up to a limit.",
      Patterns::Selection("track|reset|capped"));

    const auto update = [this](const std::string &) { set_coefficients(); };
    for (const std::string entry :
         {"Friction angle", "Cone slope", "Separation"})
      prm.add_action(entry, update);

    Parameters::only_with(prm, "Separation", "capped", separation_rule, [&] {
      prm.add_parameter("Log volume ratio cap",
                        log_volume_ratio_cap,
                        "Largest logarithm of the volume over the volume "
                        "without stress that is kept.",
                        positive_number());
      prm.add_action("Log volume ratio cap", update);
    });
  }



  void
  DruckerPragerParameters::check() const
  {
    elastic_moduli.check();
  }
} // namespace mpm_granular::Materials
