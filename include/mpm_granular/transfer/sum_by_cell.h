#ifndef mpm_granular_transfer_sum_by_cell_h
#define mpm_granular_transfer_sum_by_cell_h

#include <mpm_granular/transfer/point_block.h>

namespace mpm_granular::Transfer
{
  /**
   * Calls @p action(cell, range) for the points of a block that follow each
   * other in the same cell, at their new places: mostly whole runs.
   */
  template <int dim, class Action>
  inline void
  for_each_in_same_cell(const Points::PointArrays<dim> &points,
                        const PointBlock<dim>          &block,
                        Action                        &&action)
  {
    const unsigned int *const cell = points.cell.data();
    for (const auto &run : block.runs)
      for (unsigned int begin = run.begin, end = begin; begin < run.end;
           begin = end)
        {
          do
            ++end;
          while (end < run.end && cell[end] == cell[begin]);
          action(cell[begin], Points::Run{begin, end});
        }
  }

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
    for_each_in_same_cell(
      points, block, [&](const unsigned int cell, const auto &range) {
        Sums sums{};
        for (unsigned int p = range.begin; p < range.end; ++p)
          contribute(p, sums);
        store(cell, sums);
      });
  }
} // namespace mpm_granular::Transfer

#endif
