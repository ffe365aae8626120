#include <deal.II/base/patterns.h>

#include <mpm_granular/materials/separation_rule.h>
#include <mpm_granular/parameters/documentation_handler.h>
#include <mpm_granular/parameters/pattern_text.h>

#include <limits>

namespace mpm_granular::Materials
{
  SeparationRule::SeparationRule()
  {
    set_limit();
  }



  void
  SeparationRule::set_limit()
  {
    limit = rule == "reset"  ? 0. :
            rule == "capped" ? cap :
                               std::numeric_limits<double>::infinity();
  }



  void
  SeparationRule::add_parameters(dealii::ParameterHandler &prm)
  {
    const auto update = [this](const std::string &) { set_limit(); };
    prm.add_parameter(
      "Separation",
      rule,
      "What becomes of the volume ratio of a point that is larger than without "
      "stress. 'track': it is kept, the gap must close before pressure "
      "returns. 'reset': it is forgotten, pressure returns at once; the volume "
      "grows with every opening. 'capped': it is kept up to a limit.",
      dealii::Patterns::Selection("track|reset|capped"));
    prm.add_action("Separation", update);

    Parameters::only_with(prm, "Separation", "capped", rule, [&] {
      prm.add_parameter("Log volume ratio cap",
                        cap,
                        "Largest logarithm of the volume over the volume "
                        "without stress that is kept.",
                        Parameters::positive_number());
      prm.add_action("Log volume ratio cap", update);
    });
  }
} // namespace mpm_granular::Materials
