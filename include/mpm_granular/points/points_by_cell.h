#ifndef mpm_granular_points_points_by_cell_h
#define mpm_granular_points_points_by_cell_h

#include <mpm_granular/points/point_arrays.h>

#include <vector>

namespace mpm_granular::Points
{
  /// The points of each cell that has any, by cell and within a cell by id: an
  /// order that does not depend on that of the arrays.
  template <int dim>
  std::vector<std::vector<unsigned int>>
  points_by_cell(const PointArrays<dim> &points);
} // namespace mpm_granular::Points

#endif
