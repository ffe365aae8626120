#ifndef mpm_granular_points_migration_h
#define mpm_granular_points_migration_h

#include <mpm_granular/mesh/partition.h>
#include <mpm_granular/points/point_arrays.h>

#include <cstddef>

namespace mpm_granular::Points
{
  /**
   * Sends each point that is in a cell of another rank to that rank, with all
   * its arrays to the last bit. To be called by all ranks. Points that stay
   * keep their order; those that come are behind them, by rank. Points whose
   * cell is Mesh::no_cell stay.
   *
   * @param points with global numbers of their cells.
   * @return how many points this rank sent.
   */
  template <int dim>
  std::size_t
  migrate(const Mesh::Partition<dim> &partition, PointArrays<dim> &points);
} // namespace mpm_granular::Points

#endif
