#include <mpm_granular/checkpoint/checkpoint_parameters.h>

namespace mpm_granular::Checkpoint
{
  using namespace dealii::Patterns;

  void
  CheckpointParameters::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Wall time interval",
                      wall_interval,
                      "Wall time between two checkpoints; 0: none because of "
                      "wall time. SIGINT, SIGTERM and SIGUSR1 always cause a "
                      "checkpoint. Units: s.",
                      Double(0.));
    prm.add_parameter("Time interval",
                      time_interval,
                      "Simulated time between two checkpoints; steps are not "
                      "cut to end there. 0: none because of simulated time. "
                      "Units: s.",
                      Double(0.));
    prm.add_parameter("Step interval",
                      step_interval,
                      "Time steps between two checkpoints; 0: none because of "
                      "steps.",
                      Integer(0));
    prm.add_parameter("At end",
                      at_end,
                      "Whether a checkpoint is written at the end time, from "
                      "which the run can be continued to a later one.");
    prm.add_parameter("Number kept",
                      n_kept,
                      "So many of the newest checkpoints stay; the older ones "
                      "are removed.",
                      Integer(1));
  }
} // namespace mpm_granular::Checkpoint
