#ifndef mpm_granular_checkpoint_checkpoint_parameters_h
#define mpm_granular_checkpoint_checkpoint_parameters_h

#include <mpm_granular/parameters/parameter_group.h>

namespace mpm_granular::Checkpoint
{
  /// When checkpoints are written. Entries of the current subsection.
  struct CheckpointParameters : Parameters::ParameterGroup
  {
    unsigned int step_interval = 0;    ///< 0: not by steps
    double       time_interval = 0.;   ///< simulated [s]; 0: not by time
    double       wall_interval = 600.; ///< [s]; 0: not by wall time
    bool         at_end        = true; ///< of a run that was not interrupted
    unsigned int n_kept        = 2;

    void
    add_parameters(dealii::ParameterHandler &prm) override;
  };
} // namespace mpm_granular::Checkpoint

#endif
