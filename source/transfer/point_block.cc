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
    begin                      = first;
    end                        = first;
    const unsigned int n       = points.size();
    const unsigned int desired = std::min<std::size_t>(first + target_size, n);
    while (end < desired)
      {
        const unsigned int run_begin = end;
        while (end < n && points.cell[end] == points.cell[run_begin] &&
               points.material[end] == points.material[run_begin])
          ++end;
        runs.push_back({run_begin, end});
      }
    if (shape_values[0].size() < end - begin)
      for (auto &values : shape_values)
        values.resize(end - begin);
  }

  template struct PointBlock<2>;
  template struct PointBlock<3>;
} // namespace mpm_granular::Transfer
