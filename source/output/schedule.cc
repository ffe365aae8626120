#include <mpm_granular/output/schedule.h>

#include <cmath>
#include <limits>

namespace mpm_granular::Output
{
  Schedule::Schedule(const double interval, const double start)
    : interval(interval)
    , start(start)
    , n_passed(0)
  {}



  double
  Schedule::next() const
  {
    return interval > 0. ? start + (n_passed + 1) * interval :
                           std::numeric_limits<double>::infinity();
  }



  bool
  Schedule::passes(const double time)
  {
    if (!(interval > 0.))
      return false;
    // A step that was cut to end on an instant ends there up to round-off.
    const double tolerance = 1e-9 * interval + 1e-14 * std::abs(time);
    const double n_reached = std::floor((time + tolerance - start) / interval);
    if (n_reached <= n_passed)
      return false;
    n_passed = static_cast<unsigned int>(n_reached);
    return true;
  }
} // namespace mpm_granular::Output
