#ifndef mpm_granular_observables_run_state_h
#define mpm_granular_observables_run_state_h

#include <mpm_granular/observables/observable.h>

namespace mpm_granular::Observables
{
  /// Time, number of steps, time step, number and mass of the points, number of
  /// lost points.
  template <int dim>
  class RunState : public Observable<dim>
  {
  public:
    std::vector<std::string>
    columns() const override;

    std::vector<double>
    values(const Snapshot<dim> &snapshot, const Frame<dim> &frame) override;
  };
} // namespace mpm_granular::Observables

#endif
