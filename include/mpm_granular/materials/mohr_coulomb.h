#ifndef mpm_granular_materials_mohr_coulomb_h
#define mpm_granular_materials_mohr_coulomb_h

#include <mpm_granular/materials/coulomb_strength.h>
#include <mpm_granular/materials/granular_law.h>
#include <mpm_granular/materials/perzyna_flow.h>

namespace mpm_granular::Materials
{
  /**
   * The pyramid of Mohr and Coulomb with cohesion, dilatancy and tension
   * cut-off, with Perzyna's flow or rate-independent (T54-T57).
   */
  template <int dim>
  class MohrCoulomb : public GranularLaw<dim>
  {
  public:
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
    CoulombStrength strength;
    PerzynaFlow     perzyna;
  };
} // namespace mpm_granular::Materials

#endif
