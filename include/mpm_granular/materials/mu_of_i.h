#ifndef mpm_granular_materials_mu_of_i_h
#define mpm_granular_materials_mu_of_i_h

#include <mpm_granular/materials/granular_law.h>

namespace mpm_granular::Materials
{
  /**
   * The mu(I) rheology of dense granular flow @cite jop2006, elastic below
   * yield, without tension and at constant volume. The step of backward Euler
   * has a closed form (T58b) @cite dunatunga_kamrin2015.
   */
  template <int dim>
  class MuOfI : public GranularLaw<dim>
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
      return 0.;
    }

    double
    mobilization(const Stress<dim> &stress) const override;

  private:
    double static_friction  = 0.38;
    double largest_friction = 0.64;
    double inertial_number  = 0.279;
    double grain_diameter   = 0.001;
    double grain_density    = 2500.;
  };
} // namespace mpm_granular::Materials

#endif
