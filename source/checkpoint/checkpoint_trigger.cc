#include <mpm_granular/checkpoint/checkpoint_trigger.h>
#include <mpm_granular/core/signals.h>

#include <cmath>

namespace mpm_granular::Checkpoint
{
  CheckpointTrigger::CheckpointTrigger(const CheckpointParameters &parameters,
                                       const bool                  keeps_time)
    : parameters(parameters)
    , keeps_time(keeps_time && parameters.wall_interval > 0.)
    , last_written(Clock::now())
  {}



  void
  CheckpointTrigger::start(const double time)
  {
    n_passed = n_intervals(time);
  }



  bool
  CheckpointTrigger::is_asked_for() const
  {
    return Core::take_checkpoint_request() ||
           (keeps_time &&
            std::chrono::duration<double>(Clock::now() - last_written)
                .count() >= parameters.wall_interval);
  }



  bool
  CheckpointTrigger::is_due(const unsigned int step,
                            const double       time,
                            const bool         is_asked_for_anywhere)
  {
    const double n_now = n_intervals(time);
    const bool   is_at_step =
      parameters.step_interval > 0 && step % parameters.step_interval == 0;
    if (!is_at_step && n_now <= n_passed && !is_asked_for_anywhere)
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
