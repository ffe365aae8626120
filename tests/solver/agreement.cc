// What ranks tell each other after a step: least, greatest and summed values,
// what any of them asks for, and the error of the first.

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/solver/agreement.h>

#include <iostream>

using namespace mpm_granular;
namespace Mpi = dealii::Utilities::MPI;

const char *
text_of(const bool value)
{
  return value ? "yes" : "no";
}



int
main(int argc, char **argv)
{
  const Mpi::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int          rank     = Mpi::this_mpi_process(MPI_COMM_WORLD);
  const bool                  is_first = rank == 0;
  const bool is_last = rank + 1 == Mpi::n_mpi_processes(MPI_COMM_WORLD);

  Solver::RankReport report;
  report.critical_step         = 1. + rank;
  report.least_altitude        = 4. - rank;
  report.motion.speed_squared  = rank * rank;
  report.motion.kinetic_energy = 1. + rank;
  report.n_points              = 10 * (1 + rank);
  report.is_out_of_reach       = false;
  for (const bool stop : {false, true})
    for (const bool checkpoint : {false, true})
      {
        // Not from the same rank.
        report.requests      = {stop && is_last, checkpoint && is_first};
        const auto agreement = Solver::agree(report, MPI_COMM_WORLD);
        if (is_first)
          std::cout << "Stop " << text_of(agreement.requests.stop)
                    << ", checkpoint " << text_of(agreement.requests.checkpoint)
                    << std::endl;
      }

  const auto agreement = Solver::agree(report, MPI_COMM_WORLD);
  if (is_first)
    std::cout << "Step " << agreement.limits.critical_step << ", altitude "
              << agreement.limits.least_altitude << ", energy "
              << agreement.kinetic_energy << ", points " << agreement.n_points
              << ", imbalance " << agreement.imbalance << std::endl;
  try
    {
      if (!is_first)
        report.error = "of rank " + std::to_string(rank);
      if (is_last && is_first)
        report.error = "of the only rank";
      Solver::agree(report, MPI_COMM_WORLD);
    }
  catch (const ComputationError &error)
    {
      if (is_last)
        std::cout << "Error " << error.what() << std::endl;
    }
}
