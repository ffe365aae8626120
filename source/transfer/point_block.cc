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
    const unsigned int  n        = points.size();
    const unsigned int *cell     = points.cell.data();
    const auto         *material = points.material.data();
    const auto          begins   = [&](const unsigned int p) {
      return (cell[p] != cell[p - 1]) | (material[p] != material[p - 1]);
    };
    begin = first;
    end   = std::min(first + target_size, n);

    // Where a run begins cannot be predicted, so there is no branch on it: ends
    // and beginnings that are none are overwritten. 4 % of a step.
    runs.resize(target_size + 1);
    unsigned int last = 0;
    runs[0].begin     = first;
    for (unsigned int p = first + 1; p < end; ++p)
      {
        runs[last].end       = p;
        runs[last + 1].begin = p;
        last += begins(p);
      }
    while (end < n && !begins(end))
      ++end;
    runs[last].end = end;
    runs.resize(last + 1);

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
