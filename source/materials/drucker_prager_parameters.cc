#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/patterns.h>

#include <mpm_granular/materials/drucker_prager_parameters.h>
#include <mpm_granular/parameters/pattern_text.h>

#include <cmath>

namespace mpm_granular::Materials
{
  using namespace dealii;

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



  void
  add_cone_slope(ParameterHandler &prm, std::string &rule)
  {
    prm.add_parameter(
      "Cone slope",
      rule,
      "What the slope m of the cone q = m p is fitted to, with the sine S of "
      "the friction angle. 'paper': m = 18 S/(9 - S^2), the mean of the next "
      "two. 'triaxial compression': m = 6 S/(3 - S). 'triaxial extension': "
      "m = 6 S/(3 + S). 'plane strain': m = sqrt(3) S, so that the friction in "
      "plane flow at constant volume is that of the friction angle.",
      Patterns::Selection(
        "paper|triaxial compression|triaxial extension|plane strain"));
  }



  DruckerPragerParameters::DruckerPragerParameters()
  {
    set_slope();
  }



  void
  DruckerPragerParameters::set_slope()
  {
    slope = slope_of_cone(cone_slope_rule, friction_angle);
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
    add_cone_slope(prm, cone_slope_rule);
    perzyna.add_parameters(prm);
    separation.add_parameters(prm);

    const auto update = [this](const std::string &) { set_slope(); };
    for (const std::string entry : {"Friction angle", "Cone slope"})
      prm.add_action(entry, update);
  }



  void
  DruckerPragerParameters::check() const
  {
    elastic_moduli.check();
  }
} // namespace mpm_granular::Materials
