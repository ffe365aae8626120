#ifndef mpm_granular_observables_center_of_mass_h
#define mpm_granular_observables_center_of_mass_h

#include <mpm_granular/observables/observable.h>

namespace mpm_granular::Observables
{
  /// The center of mass; in the plane its z is zero.
  template <int dim>
  class CenterOfMass : public Observable<dim>
  {
  public:
    std::vector<std::string>
    columns() const override;

    std::vector<double>
    values(const Snapshot<dim> &snapshot, const Frame<dim> &frame) override;
  };
} // namespace mpm_granular::Observables

#endif
