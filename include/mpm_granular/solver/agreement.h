#ifndef mpm_granular_solver_agreement_h
#define mpm_granular_solver_agreement_h

#include <deal.II/base/mpi.h>

#include <mpm_granular/points/motion.h>
#include <mpm_granular/time/step_control.h>

#include <cstdint>
#include <string>

namespace mpm_granular::Solver
{
  /// What a rank asks for; it happens after the step if any rank asks.
  struct Requests
  {
    bool stop       = false;
    bool checkpoint = false;
  };

  /// What a rank has to tell the others after a step.
  struct RankReport
  {
    double         critical_step;  ///< of its active cells [s]
    double         least_altitude; ///< of its active cells [m]
    Points::Motion motion;         ///< of its points
    std::uint64_t  n_points;
    std::uint64_t  n_runs;          ///< of points in the same cell, see Sweep
    bool           is_out_of_reach; ///< a point has to go to another rank
    Requests       requests;
    std::string    error; ///< why it cannot go on; empty if it can
  };

  /// What all ranks know then.
  struct Agreement
  {
    Time::StepLimits limits;
    double           kinetic_energy = 0.; ///< [J], in 2D [J/m]
    std::uint64_t    n_points       = 0;  ///< on all ranks
    std::uint64_t    n_runs         = 0;  ///< on all ranks
    double           imbalance      = 0.; ///< most points over the mean, less 1
    bool             is_out_of_reach = false;
    Requests         requests; ///< of any rank
  };

  /**
   * Brings the reports of all ranks together, in one message.
   *
   * @throws ComputationError on all ranks, with the message of the first, if
   *   there is an error on any.
   */
  Agreement
  agree(const RankReport &report, const MPI_Comm communicator);
} // namespace mpm_granular::Solver

#endif
