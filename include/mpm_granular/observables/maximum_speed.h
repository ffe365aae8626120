#ifndef mpm_granular_observables_maximum_speed_h
#define mpm_granular_observables_maximum_speed_h

#include <mpm_granular/observables/observable.h>

namespace mpm_granular::Observables
{
  /// The largest speed of a point: whether the body rests, and whether single
  /// points run away.
  template <int dim>
  class MaximumSpeed : public Observable<dim>
  {
  public:
    std::vector<std::string>
    columns() const override;

    std::vector<double>
    values(const Snapshot<dim> &snapshot, const Frame<dim> &frame) override;
  };
} // namespace mpm_granular::Observables

#endif
