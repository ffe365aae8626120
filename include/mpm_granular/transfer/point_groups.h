#ifndef mpm_granular_transfer_point_groups_h
#define mpm_granular_transfer_point_groups_h

#include <mpm_granular/core/lanes.h>
#include <mpm_granular/core/vectorize.h>
#include <mpm_granular/points/point_arrays.h>

#include <array>
#include <cstddef>

namespace mpm_granular::Transfer
{
  /// Raw pointers to the components of a vector field.
  template <class Array, std::size_t n>
  std::array<double *, n>
  pointers(std::array<Array, n> &components)
  {
    std::array<double *, n> result;
    for (unsigned int d = 0; d < n; ++d)
      result[d] = components[d].data();
    return result;
  }

  template <class Array, std::size_t n>
  std::array<const double *, n>
  pointers(const std::array<Array, n> &components)
  {
    std::array<const double *, n> result;
    for (unsigned int d = 0; d < n; ++d)
      result[d] = components[d].data();
    return result;
  }

  /// The components of a vector field at a point (Number = double) or at four.
  template <class Number, class Pointer, std::size_t n>
  std::array<Number, n>
  load_all(const std::array<Pointer, n> &components, const std::size_t index)
  {
    std::array<Number, n> result;
    for (unsigned int d = 0; d < n; ++d)
      result[d] = load<Number>(components[d] + index);
    return result;
  }

  /**
   * Calls @p action(type, p) for the points of a run, four at a time from
   * point p on (type Lanes), of which the last may be beyond the end of the
   * run. Or one by one (type double), if they could be beyond the last of all
   * points: in a loop of its own, or the four would be slower. The index p is
   * wide, as compilers add no numbers to one that could wrap.
   */
  template <class Action>
  inline void
  for_each_group(const Points::Run  run,
                 const unsigned int n_points,
                 Action           &&action)
  {
    if (run.end + Lanes::n - 1 <= n_points)
      {
        MPM_FEW_ITERATIONS
        for (std::size_t p = run.begin; p < run.end; p += Lanes::n)
          action(Lanes(), p);
      }
    else
      for (std::size_t p = run.begin; p < run.end; ++p)
        action(double(), p);
  }
} // namespace mpm_granular::Transfer

#endif
