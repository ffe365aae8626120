#include <mpm_granular/core/lanes.h>
#include <mpm_granular/transfer/point_block.h>

#include <algorithm>

namespace mpm_granular::Transfer
{
  template <int dim>
  void
  PointBlock<dim>::reinit(const Points::PointArrays<dim> &points,
                          const unsigned int              first)
  {
    runs.clear();
    begin                        = first;
    end                          = first;
    const unsigned int  n        = points.size();
    const unsigned int  desired  = std::min(first + target_size, n);
    const unsigned int *cell     = points.cell.data();
    const auto         *material = points.material.data();
    while (end < desired)
      {
        const unsigned int run_begin = end;
        do
          ++end;
        while (end < n && cell[end] == cell[run_begin] &&
               material[end] == material[run_begin]);
        runs.push_back({run_begin, end});
      }
    const unsigned int size = end - begin + Lanes::n;
    if (heights.size() < size)
      {
        const auto resize = [&](Array &array) { array.resize(size); };
        std::for_each(shape_values.begin(), shape_values.end(), resize);
        std::for_each(position.begin(), position.end(), resize);
        std::for_each(velocity.begin(), velocity.end(), resize);
        resize(heights);
      }
  }

  template <int dim>
  void
  PointBlock<dim>::find_parts(const Points::PointArrays<dim> &points)
  {
    const unsigned int *cell = points.cell.data();
    parts.clear();
    unsigned int next = 0; // of the movers
    for (const auto &run : runs)
      {
        unsigned int first = run.begin;
        for (; next < movers.size() && movers[next] < run.end; ++next)
          for (const unsigned int p : {movers[next], movers[next] + 1})
            if (p > first && p < run.end && cell[p] != cell[p - 1])
              {
                parts.push_back({cell[first], {first, p}});
                first = p;
              }
        parts.push_back({cell[first], {first, run.end}});
      }
  }

  template struct PointBlock<2>;
  template struct PointBlock<3>;
} // namespace mpm_granular::Transfer
