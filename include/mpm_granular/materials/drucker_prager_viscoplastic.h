#ifndef mpm_granular_materials_drucker_prager_viscoplastic_h
#define mpm_granular_materials_drucker_prager_viscoplastic_h

#include <mpm_granular/materials/constitutive_law.h>
#include <mpm_granular/materials/drucker_prager_parameters.h>

namespace mpm_granular::Materials
{
  /**
   * Cohesionless material on the cone of Drucker and Prager
   * @cite drucker_prager1952, q = m p (T5), with Perzyna's viscoplastic flow
   * @cite perzyna1966 at constant volume (T6), after
   * @cite wieckowski_pawlak.
   *
   * The pressure follows from the volume of each point, p = max(0, -K ln J_s)
   * (T7): a point that is larger than without stress is separated and has no
   * stress at all, and it carries pressure again when it is back at that
   * volume. The deviator is rotated (T18) and returned to the cone by backward
   * Euler (T20).
   */
  template <int dim>
  class DruckerPragerViscoplastic : public ConstitutiveLaw<dim>
  {
  public:
    /// Slots of the history.
    enum Slot
    {
      equivalent_viscoplastic_strain, ///< sum of gamma Phi dt [-]
      log_volume_ratio                ///< ln J_s of (T7) [-]
    };

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    std::vector<std::string>
    history_names() const override
    {
      return {"equivalent_viscoplastic_strain", "log_volume_ratio"};
    }

    double
    density() const override
    {
      return parameters.density();
    }

    double
    bulk_modulus() const override
    {
      return parameters.moduli().bulk();
    }

    double
    shear_modulus() const override
    {
      return parameters.moduli().shear();
    }

    /// Slope m of the cone (T5) [-].
    double
    cone_slope() const
    {
      return parameters.cone_slope();
    }

    /// No viscoplastic strain; ln J_s from the pressure (T27).
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
      return parameters.moduli().energy_density(stress);
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

    double
    replace_pressure(Points::PointArrays<dim> &points,
                     const Points::Run         run,
                     const double             *target) const override;

    /// The pressure is that of ln J_s, at the same q/p.
    void
    reconcile(Points::PointArrays<dim> &points,
              const Points::Run         run) const override;

    std::string
    remark_on(const Stress<dim> &initial_stress) const override;

  private:
    struct Trial;

    /// Rotates the deviators and adds the elastic strain (T18); the pressure
    /// and ln J_s become final (T7, T19).
    void
    predict(Points::PointArrays<dim>    &points,
            const Points::Run            batch,
            const StrainIncrements<dim> &increments,
            Trial                       &trial) const;

    /// q / q_tr of all points (T20).
    void
    find_factors(const unsigned int n_points,
                 const double       time_step,
                 Trial             &trial) const;

    /// Scales the deviators, adds the viscoplastic strain.
    /// @return energy released [J, in 2D J/m].
    double
    correct(Points::PointArrays<dim> &points,
            const Points::Run         batch,
            Trial                    &trial) const;

    DruckerPragerParameters parameters;
  };
} // namespace mpm_granular::Materials

#endif
