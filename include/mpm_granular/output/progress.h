#ifndef mpm_granular_output_progress_h
#define mpm_granular_output_progress_h

#include <mpm_granular/output/console.h>

#include <chrono>
#include <cstdint>
#include <string>

namespace mpm_granular::Output
{
  /// Where the computation stands.
  struct ProgressState
  {
    double        time;           ///< [s]
    double        time_step;      ///< last dt [s]
    unsigned int  step;           ///< number of steps done
    std::uint64_t n_point_steps;  ///< points times steps done
    double        kinetic_energy; ///< [J], in 2D [J/m]
  };

  /**
   * Reports how far the computation is: on a terminal a line that renews itself
   * several times a second, elsewhere and in the log a line at intervals of
   * wall time.
   */
  class Progress
  {
  public:
    /**
     * The clock starts now.
     *
     * @param console where to.
     * @param start_time simulated time at the start [s].
     * @param end_time simulated time at the end [s].
     * @param interval wall time between two plain lines [s].
     */
    Progress(Console     &console,
             const double start_time,
             const double end_time,
             const double interval);

    /// Whether a report is due now: cheap, so that what a report needs is
    /// computed only when this says so.
    bool
    is_due() const;

    /// Reports @p state now.
    void
    report(const ProgressState &state);

    /// Wall time since the start [s].
    double
    wall_time() const;

  private:
    using Clock = std::chrono::steady_clock;

    /// The line that describes @p state.
    std::string
    line(const ProgressState &state) const;

    Console          &console;
    const double      start_time;
    const double      end_time;
    const double      interval;
    const double      terminal_interval;
    Clock::time_point begin;
    double            last_report; ///< wall time [s]
    double            last_line;   ///< wall time [s]
  };

  /// What is said when the time loop is over.
  struct Summary
  {
    double        simulated_time; ///< [s]
    unsigned int  n_steps;
    std::uint64_t n_point_steps;   ///< points times steps
    double        loop_time;       ///< wall time of the loop without output [s]
    double        bytes_per_point; ///< memory of the points
  };

  /**
   * The summary as text, with the two lines that other programs read:
   * `Throughput: X million point-steps/s` and `Memory: X bytes a point`.
   */
  std::string
  summary_text(const Summary &summary);

  /// Million point-steps a second of the loop without output.
  double
  throughput(const Summary &summary);
} // namespace mpm_granular::Output

#endif
