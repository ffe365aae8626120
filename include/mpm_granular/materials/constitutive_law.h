#ifndef mpm_granular_materials_constitutive_law_h
#define mpm_granular_materials_constitutive_law_h

#include <mpm_granular/core/registry.h>
#include <mpm_granular/core/stress_layout.h>
#include <mpm_granular/materials/strain_increments.h>
#include <mpm_granular/parameters/parameter_group.h>
#include <mpm_granular/points/point_arrays.h>

#include <cmath>
#include <string>
#include <vector>

namespace mpm_granular::Materials
{
  /**
   * A constitutive law: the stress of points from their strain increments.
   *
   * A law is called for a batch of consecutive points at a time, so that the
   * virtual call and everything that depends on the law alone is paid once for
   * many points. The solver calls update_stress(), which makes the batches.
   */
  template <int dim>
  class ConstitutiveLaw : public Parameters::ParameterGroup
  {
  public:
    /// Names of the history slots the law uses, in the order of
    /// PointArrays::history; they are also the names of output fields.
    virtual std::vector<std::string>
    history_names() const
    {
      return {};
    }

    virtual double
    density() const = 0; ///< at zero stress [kg/m^3]
    virtual double
    bulk_modulus() const = 0; ///< [Pa]
    virtual double
    shear_modulus() const = 0; ///< [Pa]

    /// Speed of pressure waves, sqrt((K + 4G/3)/rho) [m/s].
    double
    wave_speed() const
    {
      return std::sqrt((bulk_modulus() + 4. / 3. * shear_modulus()) /
                       density());
    }

    /// Whether points separate: their volume then has gaps in it that bear no
    /// stress.
    virtual bool
    forms_gaps() const
    {
      return false;
    }

    /// Sets the history of points [run.begin, run.end) to what belongs to the
    /// stress they have now.
    virtual void
    initialize(Points::PointArrays<dim> &points,
               const Points::Run         run) const = 0;

    /**
     * Advances stress and history of the points [batch.begin, batch.end), at
     * most StrainIncrements::capacity, over a step. Volumes have been advanced
     * before.
     *
     * @param increments entry i belongs to point batch.begin + i.
     * @return elastic energy that the law took out of the points, by viscous or
     *   plastic flow or separation [J, in 2D J/m].
     */
    virtual double
    update(Points::PointArrays<dim>    &points,
           const Points::Run            batch,
           const StrainIncrements<dim> &increments) const = 0;

    /// Elastic energy per current volume at a stress [J/m^3].
    virtual double
    elastic_energy_density(const Stress<dim> &stress) const = 0;

    /**
     * Whether the law lets the pressure of points in contact be smoothed
     * (T29): laws whose points keep no stress that the grid does not feel, as
     * elasticity, have no use for it.
     */
    virtual bool
    has_smoothable_pressure() const
    {
      return false;
    }

    /**
     * Replaces the pressures of those points of a run that are in contact
     * (p > 0) by given ones, at the same q/p (T29).
     *
     * @param target entry i belongs to point run.begin + i, 0 or more [Pa].
     * @return elastic energy that this took out of the points [J, in 2D J/m].
     */
    virtual double
    replace_pressure(Points::PointArrays<dim> & /*points*/,
                     const Points::Run /*run*/,
                     const double * /*target*/) const
    {
      return 0.;
    }

    /// Makes stress and history of points fit each other again, that are means
    /// of those of several points by volume (T85): where points in contact and
    /// points with a gap have become one.
    virtual void
    reconcile(Points::PointArrays<dim> & /*points*/,
              const Points::Run /*run*/) const
    {}

    /// Human-readable warnings about an initial stress (say, outside the yield
    /// surface); empty if there is none.
    virtual std::string
    remark_on(const Stress<dim> & /*initial_stress*/) const
    {
      return {};
    }
  };

  template <int dim>
  using LawRegistry = Core::Registry<ConstitutiveLaw<dim>>;
} // namespace mpm_granular::Materials

#endif
