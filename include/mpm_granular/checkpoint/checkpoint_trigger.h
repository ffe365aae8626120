#ifndef mpm_granular_checkpoint_checkpoint_trigger_h
#define mpm_granular_checkpoint_checkpoint_trigger_h

#include <deal.II/base/mpi.h>

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
    CheckpointTrigger(const CheckpointParameters &parameters,
                      const MPI_Comm              comm);

    /// What has been reached before the first step: no checkpoint is due for
    /// it.
    /// @param time [s].
    void
    start(const double time);

    /**
     * Whether a checkpoint is due, by one of the intervals or because a signal
     * asks for it. Called once after every step, by all processes, which get
     * the same answer: the first one looks at the clock, and a signal to any of
     * them counts.
     *
     * @param step number of steps done.
     * @param time [s].
     */
    bool
    is_due(const unsigned int step, const double time);

  private:
    using Clock = std::chrono::steady_clock;

    /// How many intervals of simulated time have passed.
    double
    n_intervals(const double time) const;

    const CheckpointParameters parameters;
    const MPI_Comm             comm;
    const bool                 keeps_time; ///< this process looks at the clock
    Clock::time_point          last_written;
    double                     n_passed = 0.; ///< intervals of simulated time
  };
} // namespace mpm_granular::Checkpoint

#endif
