#ifndef mpm_granular_transfer_sum_by_cell_h
#define mpm_granular_transfer_sum_by_cell_h

#include <mpm_granular/transfer/point_block.h>

namespace mpm_granular::Transfer
{
  /**
   * Sums contributions of the points of a block by cell: points that are in the
   * same cell as the one before add to local sums, which go to the cell when it
   * changes.
   *
   * @tparam Sums what is summed for a cell.
   * @param contribute contribute(p, sums) adds point p.
   * @param store store(cell, sums) adds the sums to the cell's; the cell may be
   *   Mesh::no_cell.
   */
  template <class Sums, int dim, class Contribute, class Store>
  void
  sum_by_cell(const Points::PointArrays<dim> &points,
              const PointBlock<dim>          &block,
              Contribute                    &&contribute,
              Store                         &&store)
  {
    for (const auto &run : block.runs)
      {
        Sums         sums{};
        unsigned int current = points.cell[run.begin];
        for (unsigned int p = run.begin; p < run.end; ++p)
          {
            if (points.cell[p] != current)
              {
                store(current, sums);
                sums    = Sums{};
                current = points.cell[p];
              }
            contribute(p, sums);
          }
        store(current, sums);
      }
  }
} // namespace mpm_granular::Transfer

#endif
