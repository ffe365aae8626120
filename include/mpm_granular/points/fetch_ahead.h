#ifndef mpm_granular_points_fetch_ahead_h
#define mpm_granular_points_fetch_ahead_h

#include <mpm_granular/points/point_arrays.h>

#include <algorithm>

namespace mpm_granular::Points
{
  /// How many points ahead of their use arrays are asked for: about a block
  /// (Transfer::PointBlock). 100 and 400 do as well.
  constexpr unsigned int n_points_ahead = 200;

  /// Asks the memory for what a step needs of points that are n_points_ahead
  /// of these; beyond the end that is of no effect.
  ///
  /// Points are spread over more arrays than the processor follows by itself.
  /// A little at a time: asking for a whole block at once gains nothing. 13 %
  /// of a step of a million points, 3 % of one of 40,000.
  template <int dim>
  void
  fetch_ahead(const PointArrays<dim> &points, const Run range)
  {
    constexpr unsigned int n_in_line = 64 / sizeof(double);
    for (unsigned int p = range.begin; p < range.end; p += n_in_line)
      {
        const auto fetch = [&](const auto &array) {
          __builtin_prefetch(array.data() + p + n_points_ahead);
        };
        std::for_each(points.position.begin(), points.position.end(), fetch);
        std::for_each(points.velocity.begin(), points.velocity.end(), fetch);
        std::for_each(points.stress.begin(), points.stress.end(), fetch);
        std::for_each(points.history.begin(), points.history.end(), fetch);
        fetch(points.mass);
        fetch(points.volume);
      }
  }
} // namespace mpm_granular::Points

#endif
