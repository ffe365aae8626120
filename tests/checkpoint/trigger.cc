// When checkpoints are due: by steps, by simulated time (also with steps that
// pass several intervals, and after a start in between), by wall time, and once
// for a signal.

#include "state.h"

#include <mpm_granular/checkpoint/checkpoint_trigger.h>
#include <mpm_granular/core/signals.h>

#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>

using namespace Test;

/// What one process alone decides.
bool
is_due(Checkpoint::CheckpointTrigger &trigger,
       const unsigned int             step,
       const double                   time)
{
  return trigger.is_due(step, time, trigger.is_asked_for());
}



/// Prints the steps of @p time_step at which a checkpoint is due.
void
print_steps(const std::string                      &name,
            const Checkpoint::CheckpointParameters &parameters,
            const double                            time_step,
            const unsigned int                      first_step = 0)
{
  Checkpoint::CheckpointTrigger trigger(parameters, true);
  trigger.start(first_step * time_step);
  std::cout << name << ":";
  for (unsigned int step = first_step + 1; step <= first_step + 20; ++step)
    if (is_due(trigger, step, step * time_step))
      std::cout << " " << step;
  std::cout << std::endl;
}



int
main(int argc, char **argv)
{
  const Mpi::MPI_InitFinalize      mpi(argc, argv, 1);
  Checkpoint::CheckpointParameters parameters;
  print_steps("Default", parameters, 0.1);

  parameters.wall_interval = 0.;
  parameters.step_interval = 7;
  print_steps("Every 7 steps", parameters, 0.1);
  print_steps("the same from step 10", parameters, 0.1, 10);

  parameters.step_interval = 0;
  parameters.time_interval = 0.3;
  print_steps("Every 0.3 s", parameters, 0.1);
  print_steps("with steps of 0.25 s", parameters, 0.25);
  print_steps("with steps of 1 s", parameters, 1.);
  print_steps("from 0.6 s", parameters, 0.1, 6);

  parameters.time_interval = 0.;
  parameters.wall_interval = 1e-3;
  Checkpoint::CheckpointTrigger       by_clock(parameters, true);
  const Checkpoint::CheckpointTrigger of_another_process(parameters, false);
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::cout << "After some wall time: " << is_due(by_clock, 1, 0.)
            << of_another_process.is_asked_for() << std::endl;

  parameters.wall_interval = 0.;
  Checkpoint::CheckpointTrigger by_signal(parameters, true);
  Core::catch_signals();
  std::cout << "Signal: " << is_due(by_signal, 1, 0.);
  std::raise(SIGUSR1);
  std::cout << is_due(by_signal, 2, 0.);
  std::cout << is_due(by_signal, 3, 0.) << std::endl;
}
