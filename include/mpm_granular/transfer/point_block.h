#ifndef mpm_granular_transfer_point_block_h
#define mpm_granular_transfer_point_block_h

#include <deal.II/base/array_view.h>
#include <deal.II/base/tensor.h>

#include <mpm_granular/core/lanes.h>
#include <mpm_granular/core/marks.h>
#include <mpm_granular/points/point_arrays.h>

#include <array>
#include <vector>

namespace mpm_granular::Transfer
{
  /**
   * Some hundred consecutive points, the unit in which the sweep works: small
   * enough to stay in the nearest caches while it goes from room to room,
   * large enough that calls and set-up do not count.
   */
  template <int dim>
  struct PointBlock
  {
    /// Points of a block: of all but the last. Runs end with it. It fills up
    /// three batches of a law (Materials::StrainIncrements), and
    /// for_each_marked().
    static constexpr unsigned int capacity = 192;
    static_assert(capacity % n_marks == 0);

    std::vector<Points::Run> runs; ///< one cell and material each

    /// Velocity gradients, and the points that each is for: a run in simplices,
    /// where it is the same all over a cell, or else a single point.
    std::vector<dealii::Tensor<2, dim>> gradients;
    std::vector<Points::Run>            strained;

    /// Points in sequence that have come to the same cell, perhaps
    /// Mesh::no_cell: mostly whole runs.
    struct Part
    {
      unsigned int cell;
      Points::Run  points;
    };

    std::vector<Part>         parts;  ///< set by relocate()
    std::vector<unsigned int> movers; ///< the points that have left their cells

    /// Sets the parts from the movers.
    void
    find_parts(const Points::PointArrays<dim> &points);

    /// One number for each point, with room behind them: kernels compute with
    /// whole groups of points that begin at the first of a run. What they write
    /// beyond the run's end is overwritten by the next run. Of fixed size, so
    /// that kernels need no pointer to each.
    using Array = std::array<double, capacity + Lanes::n>;

    /// Shape values of the points at their new places, by node and place in the
    /// block; as many as the cells have nodes are used.
    std::array<Array, (1u << dim)> shape_values = {};

    /// Height of the points above the nearest face of their old cells, in
    /// heights of the cell.
    Array heights = {};

    /// What becomes of the points, until it is copied to them.
    std::array<Array, dim> position = {}, velocity = {};

    unsigned int begin = 0; ///< first point
    unsigned int end   = 0; ///< past the last point

    /// Makes this the block that starts at point @p first.
    void
    reinit(const Points::PointArrays<dim> &points, const unsigned int first);
  };
} // namespace mpm_granular::Transfer

#endif
