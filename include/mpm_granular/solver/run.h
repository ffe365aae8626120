#ifndef mpm_granular_solver_run_h
#define mpm_granular_solver_run_h

#include <deal.II/base/timer.h>

#include <mpm_granular/checkpoint/checkpoint_folder.h>
#include <mpm_granular/checkpoint/checkpoint_trigger.h>
#include <mpm_granular/output/console.h>
#include <mpm_granular/output/grid_output.h>
#include <mpm_granular/output/manifest.h>
#include <mpm_granular/output/points_output.h>
#include <mpm_granular/output/preflight.h>
#include <mpm_granular/output/progress.h>
#include <mpm_granular/output/run_folder.h>
#include <mpm_granular/output/schedule.h>
#include <mpm_granular/output/timings.h>
#include <mpm_granular/parameters/run_info.h>
#include <mpm_granular/solver/mpm_solver.h>

#include <cstdint>
#include <limits>
#include <string>

namespace mpm_granular::Solver
{
  /// How a run ended, if not with an exception.
  enum class Outcome
  {
    finished,
    interrupted ///< by a signal, after a checkpoint and a last output
  };

  /**
   * A run: the computation from start to end, with what is said and written on
   * the way.
   */
  template <int dim>
  class Run
  {
  public:
    /// Sets the computation up; writes nothing.
    /// @throws InputError where the input cannot be right.
    Run(RunParameters<dim> &parameters, const Parameters::RunInfo &info);

    /// What the run will be: sizes, limits, estimates, warnings. Collective.
    Output::Preflight
    preflight() const;

    /**
     * Says the pre-flight report and, unless only that is wanted, computes
     * until the end time or a signal and writes all output.
     *
     * @throws InputError if the output folder cannot be used.
     * @throws ComputationError if the computation fails, after a last output.
     */
    Outcome
    execute();

  private:
    void
    open_output();
    void
    write_parameters() const;
    Outcome
    compute();
    Outcome
    settle();
    Outcome
    take_steps();
    void
    finish_step(Output::Progress &progress, Output::Schedule &rows);
    Requests
    requests_now() const;
    double
    next_event() const;
    void
    write_observables();
    void
    write_fields();
    void
    write_checkpoint();
    void
    serialize(Core::Archive &archive);
    void
    restore();
    void
    reopen_output();
    void
    close_output(const Output::Manifest::Outcome outcome,
                 const std::string              &message);

    RunParameters<dim>       &parameters;
    const Parameters::RunInfo info;
    const bool                is_first_rank;
    const dealii::Timer       since_start;
    MPMSolver<dim>            solver;
    Output::RunFolder         folder;
    Output::Console           console;
    Output::PointsOutput<dim> points_output;
    Output::GridOutput<dim>   grid_output;
    Output::Manifest          manifest;
    Output::Timings           timings;
    Output::Schedule          field_times;
    Output::Schedule          observable_times;

    Checkpoint::CheckpointFolder  checkpoints;
    Checkpoint::CheckpointTrigger checkpoint_trigger;

    static constexpr double no_time = std::numeric_limits<double>::lowest();

    std::uint64_t n_point_steps   = 0;
    double        last_written    = no_time; ///< fields, time [s]
    double        last_row        = no_time; ///< of observables, time [s]
    std::uint64_t checkpoint_step = never;   ///< of the newest checkpoint

    /// What had been done when the run was continued, so that speeds are of
    /// this start and counts of all.
    struct Before
    {
      double        time          = 0.; ///< [s]
      std::uint64_t n_steps       = 0;
      std::uint64_t n_point_steps = 0;
      double        loop_time     = 0.; ///< [s]
    } before;

    static constexpr std::uint64_t never =
      std::numeric_limits<std::uint64_t>::max();

    const unsigned int in_steps, in_observables, in_fields,
      in_checkpoints; ///< of timings
  };
} // namespace mpm_granular::Solver

#endif
