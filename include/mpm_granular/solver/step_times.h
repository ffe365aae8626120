#ifndef mpm_granular_solver_step_times_h
#define mpm_granular_solver_step_times_h

#include <array>
#include <chrono>

namespace mpm_granular::Solver
{
  /// Wall time of the parts of a time step, summed over the steps: a stopwatch
  /// that is read where one part ends and the next begins.
  class StepTimes
  {
  public:
    enum Part
    {
      nodes,    ///< sums of the nodes from the cells, conditions, loads
      momentum, ///< velocities of the nodes
      points,   ///< the sweep over the points
      ledger,   ///< energies
      rest,     ///< agreement of the ranks, migration, order
      n_parts
    };

    static constexpr std::array<const char *, n_parts> names{
      {"nodes", "momentum", "points", "ledger", "rest"}};

    std::array<double, n_parts> seconds{}; ///< of this rank

    void
    begin()
    {
      last = std::chrono::steady_clock::now();
    }

    /// What has been done since begin() or the last call belongs to @p part.
    void
    end(const Part part)
    {
      const auto now = std::chrono::steady_clock::now();
      seconds[part] += std::chrono::duration<double>(now - last).count();
      last = now;
    }

  private:
    std::chrono::steady_clock::time_point last;
  };
} // namespace mpm_granular::Solver

#endif
