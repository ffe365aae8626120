#ifndef mpm_granular_materials_drucker_prager_parameters_h
#define mpm_granular_materials_drucker_prager_parameters_h

#include <mpm_granular/materials/elastic_moduli.h>
#include <mpm_granular/materials/perzyna_flow.h>
#include <mpm_granular/materials/separation_rule.h>
#include <mpm_granular/parameters/parameter_group.h>

#include <string>

namespace mpm_granular::Materials
{
  /// Slope of the cone (T5) by a rule of 'Cone slope' [-].
  /// @param angle friction angle [degrees].
  double
  slope_of_cone(const std::string &rule, const double angle);

  /// Declares 'Cone slope' and binds it to @p rule.
  void
  add_cone_slope(dealii::ParameterHandler &prm, std::string &rule);



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
      return perzyna.fluidity;
    }

    /// N of (T6) [-].
    double
    exponent() const
    {
      return perzyna.exponent;
    }

    /// The upper limit of ln J_s (T7): infinite for 'track', 0 for 'reset' [-].
    double
    largest_log_volume_ratio() const
    {
      return separation.largest_gap();
    }

  private:
    /// Derives the slope from the entries; called whenever one of these is set.
    void
    set_slope();

    double           initial_density = 1500.;
    ElasticModuli    elastic_moduli;
    double           friction_angle  = 30.;
    std::string      cone_slope_rule = "paper";
    PerzynaConstants perzyna;
    SeparationRule   separation;
    double           slope;
  };
} // namespace mpm_granular::Materials

#endif
