#ifndef mpm_granular_materials_drucker_prager_cohesive_h
#define mpm_granular_materials_drucker_prager_cohesive_h

#include <mpm_granular/materials/coulomb_strength.h>
#include <mpm_granular/materials/granular_law.h>
#include <mpm_granular/materials/perzyna_flow.h>

#include <string>

namespace mpm_granular::Materials
{
  /**
   * The cone of Drucker and Prager @cite drucker_prager1952 with cohesion,
   * dilatancy and a cap on tension (T51), with Perzyna's flow or
   * rate-independent. Without cohesion and dilatancy it is
   * DruckerPragerViscoplastic, which is faster.
   */
  template <int dim>
  class DruckerPragerCohesive : public GranularLaw<dim>
  {
  public:
    DruckerPragerCohesive();

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

  protected:
    void
    flow(typename GranularLaw<dim>::Stresses &stresses) const override;

    double
    apex_tension() const override
    {
      return strength.apex_tension();
    }

    double
    mobilization(const Stress<dim> &stress) const override;

  private:
    /// From the entries; called whenever one of them is set.
    void
    set_slopes();

    CoulombStrength strength;
    std::string     cone_slope_rule = "paper";
    PerzynaFlow     perzyna;
    double          friction_slope;  ///< m of (T5) [-]
    double          dilatancy_slope; ///< beta of (T51) [-]
  };
} // namespace mpm_granular::Materials

#endif
