#include <mpm_granular/points/points_by_cell.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace mpm_granular::Points
{
  template <int dim>
  std::vector<std::vector<unsigned int>>
  points_by_cell(const PointArrays<dim> &points)
  {
    std::vector<unsigned int> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
      return std::tie(points.cell[a], points.id[a]) <
             std::tie(points.cell[b], points.id[b]);
    });
    std::vector<std::vector<unsigned int>> lists;
    for (unsigned int i = 0; i < order.size(); ++i)
      {
        if (i == 0 || points.cell[order[i]] != points.cell[order[i - 1]])
          lists.emplace_back();
        lists.back().push_back(order[i]);
      }
    return lists;
  }

  template std::vector<std::vector<unsigned int>>
  points_by_cell(const PointArrays<2> &);
  template std::vector<std::vector<unsigned int>>
  points_by_cell(const PointArrays<3> &);
} // namespace mpm_granular::Points
