#ifndef mpm_granular_materials_linear_elastic_h
#define mpm_granular_materials_linear_elastic_h

#include <mpm_granular/materials/constitutive_law.h>
#include <mpm_granular/materials/elastic_moduli.h>

namespace mpm_granular::Materials
{
  /**
   * Hypoelasticity with the Jaumann rate (T3, T4): the elastic part of the
   * granular law alone, without yield and with tension. The stress is its whole
   * state:
   *
   * s' = Q (Q s Q^T + 2 G dt e) Q^T (T18), p' = p - K ln det(I + dt L) (T19).
   */
  template <int dim>
  class LinearElastic : public ConstitutiveLaw<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    double
    density() const override
    {
      return initial_density;
    }

    double
    bulk_modulus() const override
    {
      return moduli.bulk();
    }

    double
    shear_modulus() const override
    {
      return moduli.shear();
    }

    void
    initialize(Points::PointArrays<dim> &points,
               const Points::Run         run) const override;

    double
    update(Points::PointArrays<dim>    &points,
           const Points::Run            batch,
           const StrainIncrements<dim> &increments) const override;

    double
    elastic_energy_density(const Stress<dim> &stress) const override
    {
      return moduli.energy_density(stress);
    }

  private:
    double        initial_density = 1500.;
    ElasticModuli moduli;
  };
} // namespace mpm_granular::Materials

#endif
