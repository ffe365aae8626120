#ifndef mpm_granular_transfer_sum_by_cell_h
#define mpm_granular_transfer_sum_by_cell_h

#include <mpm_granular/transfer/point_block.h>

namespace mpm_granular::Transfer
{
  /**
   * Sums contributions of the points of a block by cell: points in sequence
   * that are in the same cell add to local sums, which then go to the cell.
   *
   * @tparam Sums what is summed for a cell.
   * @param contribute contribute(p, sums) adds point p.
   * @param store store(cell, sums) adds the sums to the cell's; the cell may be
   *   Mesh::no_cell.
   */
  template <class Sums, int dim, class Contribute, class Store>
  void
  sum_by_cell(const PointBlock<dim> &block,
              Contribute           &&contribute,
              Store                &&store)
  {
    for (const auto &part : block.parts)
      {
        Sums sums{};
        for (unsigned int p = part.points.begin; p < part.points.end; ++p)
          contribute(p, sums);
        store(part.cell, sums);
      }
  }
} // namespace mpm_granular::Transfer

#endif
