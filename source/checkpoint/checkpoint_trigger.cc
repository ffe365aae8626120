#include <mpm_granular/checkpoint/checkpoint_trigger.h>
#include <mpm_granular/core/signals.h>

#include <cmath>

namespace mpm_granular::Checkpoint
{
  namespace MPI = dealii::Utilities::MPI;

  CheckpointTrigger::CheckpointTrigger(const CheckpointParameters &parameters,
                                       const MPI_Comm              comm)
    : parameters(parameters)
    , comm(comm)
    , keeps_time(parameters.wall_interval > 0. &&
                 MPI::this_mpi_process(comm) == 0)
    , last_written(Clock::now())
  {}



  void
  CheckpointTrigger::start(const double time)
  {
    n_passed = n_intervals(time);
  }



  bool
  CheckpointTrigger::is_due(const unsigned int step, const double time)
  {
    const double n_now        = n_intervals(time);
    const bool   is_asked_for = Core::take_checkpoint_request();
    const bool   is_due_here =
      (parameters.step_interval > 0 && step % parameters.step_interval == 0) ||
      n_now > n_passed || is_asked_for ||
      (keeps_time &&
       std::chrono::duration<double>(Clock::now() - last_written).count() >=
         parameters.wall_interval);
    if (MPI::max(is_due_here ? 1 : 0, comm) == 0)
      return false;
    n_passed     = n_now;
    last_written = Clock::now();
    return true;
  }



  double
  CheckpointTrigger::n_intervals(const double time) const
  {
    // A step that was to end on an instant ends there up to round-off.
    return parameters.time_interval > 0. ?
             std::floor(time / parameters.time_interval + 1e-9) :
             0.;
  }
} // namespace mpm_granular::Checkpoint
