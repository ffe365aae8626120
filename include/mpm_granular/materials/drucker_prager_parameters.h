#ifndef mpm_granular_materials_drucker_prager_parameters_h
#define mpm_granular_materials_drucker_prager_parameters_h

#include <mpm_granular/materials/elastic_moduli.h>
#include <mpm_granular/parameters/parameter_group.h>

#include <string>

namespace mpm_granular::Materials
{
  /// The entries of DruckerPragerViscoplastic and what follows from them alone.
  /// The defaults are the values of @cite wieckowski_pawlak.
  class DruckerPragerParameters : public Parameters::ParameterGroup
  {
  public:
    DruckerPragerParameters();

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    /// At zero stress [kg/m^3].
    double
    density() const
    {
      return initial_density;
    }

    const ElasticModuli &
    moduli() const
    {
      return elastic_moduli;
    }

    /// m of (T5) [-].
    double
    cone_slope() const
    {
      return slope;
    }

    /// gamma of (T6) [1/s].
    double
    fluidity() const
    {
      return flow_fluidity;
    }

    /// N of (T6) [-].
    double
    exponent() const
    {
      return perzyna_exponent;
    }

    /// The upper limit of ln J_s (T7): infinite for 'track', 0 for 'reset' [-].
    double
    largest_log_volume_ratio() const
    {
      return log_volume_ratio_limit;
    }

  private:
    /// Derives the slope and the limit from the entries; called whenever one of
    /// these is set.
    void
    set_coefficients();

    double        initial_density = 1500.;
    ElasticModuli elastic_moduli;
    double        friction_angle       = 30.;
    std::string   cone_slope_rule      = "paper";
    double        flow_fluidity        = 50.;
    double        perzyna_exponent     = 1.;
    std::string   separation_rule      = "track";
    double        log_volume_ratio_cap = 0.05;

    double slope;
    double log_volume_ratio_limit;
  };
} // namespace mpm_granular::Materials

#endif
