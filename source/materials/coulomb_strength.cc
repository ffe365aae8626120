#include <deal.II/base/numbers.h>
#include <deal.II/base/patterns.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/materials/coulomb_strength.h>
#include <mpm_granular/parameters/pattern_text.h>

#include <cmath>
#include <sstream>

namespace mpm_granular::Materials
{
  using dealii::Patterns::Double;

  void
  CoulombStrength::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Friction angle",
                      phi,
                      "Angle of internal friction. Units: degrees.",
                      Parameters::positive_number(89.));
    prm.add_parameter("Cohesion",
                      shear_strength,
                      "Shear strength without normal stress. Units: Pa.",
                      Double(0.));
    prm.add_parameter("Dilatancy angle",
                      psi,
                      "How much the volume grows in flow, at most the friction "
                      "angle; 0: flow at constant volume. It is constant: "
                      "there is no critical state. Units: degrees.",
                      Double(0., 89.));
    prm.add_parameter("Tensile strength",
                      tension,
                      "The largest tension that is borne, of the mean stress "
                      "(Drucker-Prager) or a principal stress (Mohr-Coulomb); "
                      "at most that of the apex, Cohesion/tan(Friction angle). "
                      "Units: Pa.",
                      Double(0.));
  }



  double
  CoulombStrength::apex_tension() const
  {
    return shear_strength / std::tan(phi * dealii::numbers::PI / 180.);
  }



  void
  CoulombStrength::check() const
  {
    std::ostringstream text;
    if (psi > phi)
      text << "'Dilatancy angle' must not be more than 'Friction angle', "
           << phi << " degrees: more dilatancy would create energy. It is "
           << psi << '.';
    else if (tension > apex_tension() * (1. + 1e-12))
      text << "'Tensile strength' must not be more than the tension at the "
              "apex of the yield surface, Cohesion/tan(Friction angle) = "
           << apex_tension() << " Pa. It is " << tension << '.';
    if (!text.str().empty())
      throw InputError(text.str());
  }
} // namespace mpm_granular::Materials
