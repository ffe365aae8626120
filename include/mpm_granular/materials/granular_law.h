#ifndef mpm_granular_materials_granular_law_h
#define mpm_granular_materials_granular_law_h

#include <mpm_granular/materials/constitutive_law.h>
#include <mpm_granular/materials/elastic_moduli.h>
#include <mpm_granular/materials/separation_rule.h>

namespace mpm_granular::Materials
{
  /**
   * What laws of granular material have in common: elasticity (T4), a gap that
   * must close before there is pressure again (T50), the ledger (T52). A law
   * says where an elastic trial stress flows to.
   */
  template <int dim>
  class GranularLaw : public ConstitutiveLaw<dim>
  {
  public:
    /// Slots of the history.
    enum Slot
    {
      equivalent_viscoplastic_strain, ///< sum of sqrt(2/3 de:de) [-]
      gap ///< logarithm of volume by which the point is open [-]
    };

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    std::vector<std::string>
    history_names() const override
    {
      return {"equivalent_viscoplastic_strain", "gap"};
    }

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

    /// No viscoplastic strain, no gap.
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

    bool
    forms_gaps() const override
    {
      return true;
    }

    bool
    has_smoothable_pressure() const override
    {
      return true;
    }

    /// Also where there is cohesion, at the same stress over strength.
    double
    replace_pressure(Points::PointArrays<dim> &points,
                     const Points::Run         run,
                     const double             *target) const override;

    /// Closes gaps under pressure, at the same stress over strength.
    void
    reconcile(Points::PointArrays<dim> &points,
              const Points::Run         run) const override;

    std::string
    remark_on(const Stress<dim> &initial_stress) const override;

  protected:
    /// Stresses of the points of a batch, entry i of each column.
    struct Stresses
    {
      using Column = std::array<double, StrainIncrements<dim>::capacity>;

      unsigned int n_points;
      double       time_step; ///< [s]

      /// The deviator: of the trial, then at the end of the step [Pa].
      alignas(64) std::array<Column, n_stress<dim>> deviator;

      /// The pressure: of the trial, may be tension; then at the end [Pa].
      alignas(64) Column pressure;

      /// Out: increase of the gap, at the pressure at the end, >= 0 [-].
      alignas(64) Column opening;

      Stress<dim>
      deviator_of(const unsigned int index) const
      {
        Stress<dim> result;
        for (unsigned int c = 0; c < n_stress<dim>; ++c)
          result[c] = deviator[c][index];
        return result;
      }

      void
      scale_deviator(const unsigned int index, const double factor)
      {
        for (unsigned int c = 0; c < n_stress<dim>; ++c)
          deviator[c][index] *= factor;
      }
    };

    /// Puts the stresses at the end of the step in place of the elastic trial.
    virtual void
    flow(Stresses &stresses) const = 0;

    /// The tension on all sides at the apex of the yield surface [Pa].
    virtual double
    apex_tension() const = 0;

    /// Stress over strength: above 1 it flows; infinite without strength [-].
    virtual double
    mobilization(const Stress<dim> &stress) const = 0;

    ElasticModuli moduli;

  private:
    double         initial_density = 1500.;
    SeparationRule separation;
  };
} // namespace mpm_granular::Materials

#endif
