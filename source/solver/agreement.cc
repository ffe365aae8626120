#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/solver/agreement.h>

#include <array>
#include <cmath>

namespace mpm_granular::Solver
{
  using namespace dealii;

  Agreement
  agree(const RankReport &report, const MPI_Comm communicator)
  {
    enum
    {
      critical_step,
      least_altitude,
      speed_squared,
      kinetic_energy,
      n_points,
      n_runs,
      is_out_of_reach,
      wants_stop,
      wants_checkpoint,
      has_error,
      n_values
    };
    std::array<double, n_values> values;
    values[critical_step]    = report.critical_step;
    values[least_altitude]   = report.least_altitude;
    values[speed_squared]    = report.motion.speed_squared;
    values[kinetic_energy]   = report.motion.kinetic_energy;
    values[n_points]         = report.n_points;
    values[n_runs]           = report.n_runs;
    values[is_out_of_reach]  = report.is_out_of_reach;
    values[wants_stop]       = report.requests.stop;
    values[wants_checkpoint] = report.requests.checkpoint;
    values[has_error]        = !report.error.empty();

    std::array<Utilities::MPI::MinMaxAvg, n_values> all;
    Utilities::MPI::min_max_avg(
      ArrayView<const double>(values.data(), n_values),
      ArrayView<Utilities::MPI::MinMaxAvg>(all.data(), n_values),
      communicator);
    if (all[has_error].max > 0.)
      for (const auto &error :
           Utilities::MPI::all_gather(communicator, report.error))
        if (!error.empty())
          throw ComputationError(error);

    Agreement agreement;
    agreement.limits          = {all[critical_step].min,
                                 all[least_altitude].min,
                                 std::sqrt(all[speed_squared].max)};
    agreement.kinetic_energy  = all[kinetic_energy].sum;
    agreement.n_points        = all[n_points].sum;
    agreement.n_runs          = all[n_runs].sum;
    agreement.imbalance       = all[n_points].max / all[n_points].avg - 1.;
    agreement.is_out_of_reach = all[is_out_of_reach].max > 0.;
    agreement.requests        = {all[wants_stop].max > 0.,
                                 all[wants_checkpoint].max > 0.};
    if (agreement.n_points == 0)
      throw ComputationError("All points have left the mesh.");
    return agreement;
  }
} // namespace mpm_granular::Solver
