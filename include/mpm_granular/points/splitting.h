#ifndef mpm_granular_points_splitting_h
#define mpm_granular_points_splitting_h

#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/points/point_arrays.h>

#include <cstddef>

namespace mpm_granular::Points
{
  /**
   * Divides points in two where a cell has points, but fewer than a number,
   * until it has so many: the largest first, which get halves of mass and
   * volume and all else whole (T83). The halves lie in the cell, on both sides
   * of where the point was, along an edge of the cell. Points at a corner,
   * where there is no room for that, stay. All points must be in their cells.
   *
   * One half keeps the place in the arrays and the id. The other halves come
   * behind all points, in an order that does not depend on that of the points,
   * with ids from 0 on.
   *
   * @return how many points there are more.
   */
  template <int dim>
  std::size_t
  split(const Mesh::BackgroundMesh<dim> &mesh,
        PointArrays<dim>                &points,
        const unsigned int               least_per_cell);
} // namespace mpm_granular::Points

#endif
