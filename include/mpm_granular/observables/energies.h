#ifndef mpm_granular_observables_energies_h
#define mpm_granular_observables_energies_h

#include <mpm_granular/observables/observable.h>

#include <optional>

namespace mpm_granular::Observables
{
  /// The energy the points have [J, in 2D J/m].
  struct StoredEnergy
  {
    double kinetic   = 0.; ///< with the scaled mass, if it is
    double elastic   = 0.;
    double potential = 0.; ///< of gravity, zero at the mesh's lowest point

    double
    total() const
    {
      return kinetic + elastic + potential;
    }
  };

  /// The elastic energy of these points.
  template <int dim>
  double
  elastic_energy(
    const Points::PointArrays<dim>                             &points,
    const std::vector<const Materials::ConstitutiveLaw<dim> *> &laws);

  /// The energy of the points now. @p frame knows the lowest point of the mesh.
  template <int dim>
  StoredEnergy
  stored_energy(const Snapshot<dim> &snapshot, const Frame<dim> &frame);

  /**
   * The energies of the points, the ledger of what they gave and took since the
   * start, and how well the two agree: closure is what is missing or too much,
   * over the initial potential energy (over the initial total where there is no
   * gravity). It supposes that gravity does not change.
   */
  template <int dim>
  class Energies : public Observable<dim>
  {
  public:
    std::vector<std::string>
    columns() const override;

    /// The first call, and the first one that is not before time 0, define the
    /// initial state.
    std::vector<double>
    values(const Snapshot<dim> &snapshot, const Frame<dim> &frame) override;

    void
    serialize(Core::Archive &archive) override;

  private:
    std::optional<StoredEnergy> initial;
    double                      initial_time = 0.; ///< [s]
  };
} // namespace mpm_granular::Observables

#endif
