#include <deal.II/base/mpi.h>

#include <mpm_granular/observables/run_state.h>

#include <numeric>

namespace mpm_granular::Observables
{
  using namespace dealii;

  template <int dim>
  std::vector<std::string>
  RunState<dim>::columns() const
  {
    return {"time", "step", "dt", "points", "mass", "lost_points"};
  }



  template <int dim>
  std::vector<double>
  RunState<dim>::values(const Snapshot<dim> &snapshot, const Frame<dim> &)
  {
    const auto &mass   = snapshot.points.mass;
    const auto  summed = [&](const double value) {
      return Utilities::MPI::sum(value, snapshot.communicator);
    };
    return {snapshot.time,
            static_cast<double>(snapshot.step),
            snapshot.time_step,
            summed(snapshot.points.size()),
            summed(std::accumulate(mass.begin(), mass.end(), 0.)),
            summed(snapshot.n_lost)};
  }



  namespace
  {
    const RegisterObservable<RunState>
      entry("run state", "Time, steps, number and mass of the points.");
  }

  template class RunState<2>;
  template class RunState<3>;
} // namespace mpm_granular::Observables
