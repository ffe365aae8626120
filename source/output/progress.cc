#include <mpm_granular/output/number_text.h>
#include <mpm_granular/output/progress.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace mpm_granular::Output
{
  namespace
  {
    /// @p value with two decimals.
    std::string
    fixed_text(const double value)
    {
      char buffer[64];
      std::snprintf(buffer, sizeof(buffer), "%.2f", value);
      return buffer;
    }
  } // namespace



  Progress::Progress(Console     &console,
                     const double start_time,
                     const double end_time,
                     const double interval)
    : console(console)
    , start_time(start_time)
    , end_time(end_time)
    , interval(interval)
    , terminal_interval(0.2)
    , begin(Clock::now())
    , last_report(0.)
    , last_line(0.)
  {}



  double
  Progress::wall_time() const
  {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }



  bool
  Progress::is_due() const
  {
    const double now = wall_time();
    return now - last_line >= interval ||
           (console.has_terminal() && now - last_report >= terminal_interval);
  }



  void
  Progress::report(const ProgressState &state)
  {
    const std::string text = line(state);
    const double      now  = wall_time();
    last_report            = now;
    if (now - last_line >= interval)
      {
        last_line = now;
        if (console.has_terminal())
          console.log(text);
        else
          console.say(text);
      }
    console.renew(text);
  }



  std::string
  Progress::line(const ProgressState &state) const
  {
    const double done =
      end_time > start_time ?
        std::clamp((state.time - start_time) / (end_time - start_time),
                   0.,
                   1.) :
        1.;
    const double wall = wall_time();
    const double left = done > 0. ? wall * (1. - done) / done :
                                    std::numeric_limits<double>::quiet_NaN();
    char         percent[16];
    std::snprintf(percent, sizeof(percent), "%5.1f%%", 100. * done);

    return std::string(percent) + "  t " + short_text(state.time, 4) +
           " s  wall " + duration_text(wall) + "  left " + duration_text(left) +
           "  step " + count_text(state.step) + "  dt " +
           short_text(state.time_step) + " s  KE " +
           short_text(state.kinetic_energy) + " J  " +
           fixed_text(wall > 0. ? 1e-6 * state.n_point_steps / wall : 0.) +
           " M point-steps/s";
  }



  double
  throughput(const Summary &summary)
  {
    return summary.loop_time > 0. ?
             1e-6 * summary.n_point_steps / summary.loop_time :
             0.;
  }



  std::string
  summary_text(const Summary &summary)
  {
    return "Done: " + count_text(summary.n_steps) + " steps, " +
           short_text(summary.simulated_time, 6) + " s simulated in " +
           duration_text(summary.loop_time) + " (without output).\n" +
           "Throughput: " + fixed_text(throughput(summary)) +
           " million point-steps/s\n" +
           "Memory: " + short_text(std::round(summary.bytes_per_point), 9) +
           " bytes a point\n";
  }
} // namespace mpm_granular::Output
