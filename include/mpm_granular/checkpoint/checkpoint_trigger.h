#ifndef mpm_granular_checkpoint_checkpoint_trigger_h
#define mpm_granular_checkpoint_checkpoint_trigger_h

#include <mpm_granular/checkpoint/checkpoint_parameters.h>

#include <chrono>

namespace mpm_granular::Checkpoint
{
  /// Decides after each time step whether a checkpoint is due. It never has an
  /// influence on the steps.
  class CheckpointTrigger
  {
  public:
    /// The clock for the wall time starts now.
    /// @param keeps_time whether it is this process that looks at the clock.
    CheckpointTrigger(const CheckpointParameters &parameters,
                      const bool                  keeps_time);

    /// What has been reached before the first step: no checkpoint is due for
    /// it.
    /// @param time [s].
    void
    start(const double time);

    /// Whether on this process a signal, since the last call, or the clock asks
    /// for a checkpoint.
    bool
    is_asked_for() const;

    /**
     * Whether a checkpoint is due, by one of the intervals or because it is
     * asked for. Called once after every step, by all processes, which get the
     * same answer.
     *
     * @param step number of steps done.
     * @param time [s].
     * @param is_asked_for_anywhere whether is_asked_for() was true on any
     *   process.
     */
    bool
    is_due(const unsigned int step,
           const double       time,
           const bool         is_asked_for_anywhere);

  private:
    using Clock = std::chrono::steady_clock;

    /// How many intervals of simulated time have passed.
    double
    n_intervals(const double time) const;

    const CheckpointParameters parameters;
    const bool                 keeps_time;
    Clock::time_point          last_written;
    double                     n_passed = 0.; ///< intervals of simulated time
  };
} // namespace mpm_granular::Checkpoint

#endif
