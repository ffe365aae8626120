#include <mpm_granular/core/marks.h>
#include <mpm_granular/transfer/point_block.h>

#include <algorithm>
#include <cstddef>

namespace mpm_granular::Transfer
{
  template <int dim>
  void
  PointBlock<dim>::reinit(const Points::PointArrays<dim> &points,
                          const unsigned int              first)
  {
    const unsigned int  n        = points.size();
    const unsigned int *cell     = points.cell.data();
    const auto         *material = points.material.data();
    const auto          begins   = [&](const std::size_t p) {
      return (cell[p] != cell[p - 1]) | (material[p] != material[p - 1]);
    };
    begin = first;
    end   = std::min(first + capacity, n);

    runs.clear();
    unsigned int run_begin = first;
    const auto   end_run   = [&](const unsigned int p) {
      runs.push_back({run_begin, p});
      run_begin = p;
    };
    if (first + capacity < n) // as for_each_marked() looks so far
      for_each_marked(
        capacity - 1,
        [&](const std::size_t i) { return begins(first + 1 + i); },
        [&](const unsigned int i) { end_run(first + 1 + i); });
    else
      for (unsigned int p = first + 1; p < end; ++p)
        if (begins(p))
          end_run(p);
    end_run(end);
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
