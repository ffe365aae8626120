#include <deal.II/base/utilities.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/materials/elastic_moduli.h>
#include <mpm_granular/parameters/pattern_text.h>

namespace mpm_granular::Materials
{
  using namespace dealii;

  ElasticModuli::ElasticModuli()
  {
    set_moduli();
  }



  void
  ElasticModuli::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Young modulus",
                      young_modulus,
                      "Stiffness of the elastic part; with the density it sets "
                      "the wave speed and so the time step. Units: Pa.",
                      Parameters::positive_number());
    prm.add_parameter("Poisson ratio",
                      poisson_ratio,
                      "Ratio of lateral to axial strain of the elastic part, "
                      "greater than -1 and less than 0.5.",
                      Patterns::Double(-1., 0.5));
    for (const std::string entry : {"Young modulus", "Poisson ratio"})
      prm.add_action(entry, [this](const std::string &) { set_moduli(); });
  }



  void
  ElasticModuli::set_moduli()
  {
    bulk_modulus  = young_modulus / (3. * (1. - 2. * poisson_ratio));
    shear_modulus = young_modulus / (2. * (1. + poisson_ratio));
  }



  void
  ElasticModuli::check() const
  {
    require(-1. < poisson_ratio && poisson_ratio < 0.5,
            "'Poisson ratio' must be greater than -1 and less than 0.5, where "
            "a modulus becomes zero or infinite; it is " +
              Utilities::to_string(poisson_ratio) + ".");
  }
} // namespace mpm_granular::Materials
