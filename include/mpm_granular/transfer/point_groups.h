#ifndef mpm_granular_transfer_point_groups_h
#define mpm_granular_transfer_point_groups_h

#include <mpm_granular/core/lanes.h>
#include <mpm_granular/points/point_arrays.h>

#include <array>

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
  load_all(const std::array<Pointer, n> &components, const unsigned int index)
  {
    std::array<Number, n> result;
    for (unsigned int d = 0; d < n; ++d)
      result[d] = load<Number>(components[d] + index);
    return result;
  }

  /**
   * Calls @p action(type, p) for the points of a run, four at a time from
   * point p on (type Lanes) or, where the last of four would be behind the
   * last of all points, one by one (type double). The last four may go beyond
   * the end of the run.
   */
  template <class Action>
  inline void
  for_each_group(const Points::Run  run,
                 const unsigned int n_points,
                 Action           &&action)
  {
    for (unsigned int p = run.begin; p < run.end; p += Lanes::n)
      if (p + Lanes::n <= n_points)
        action(Lanes(), p);
      else
        for (unsigned int q = p; q < run.end; ++q)
          action(double(), q);
  }
} // namespace mpm_granular::Transfer

#endif
