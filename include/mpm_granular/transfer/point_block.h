#ifndef mpm_granular_transfer_point_block_h
#define mpm_granular_transfer_point_block_h

#include <deal.II/base/array_view.h>
#include <deal.II/base/tensor.h>

#include <mpm_granular/points/point_arrays.h>

#include <array>
#include <vector>

namespace mpm_granular::Transfer
{
  /**
   * Some hundred consecutive points, the unit in which the sweep works: small
   * enough to stay in the first-level cache while it goes from room to room,
   * large enough that calls and set-up do not count.
   */
  template <int dim>
  struct PointBlock
  {
    /// Points per block; a run that begins within it is taken whole.
    static constexpr unsigned int target_size = 192;

    std::vector<Points::Run> runs; ///< one cell and material each

    /// Velocity gradients, and the points that each is for: a run in simplices,
    /// where it is the same all over a cell, or else a single point.
    std::vector<dealii::Tensor<2, dim>> gradients;
    std::vector<Points::Run>            strained;

    /// Shape values of the points at their new places, by node and place in the
    /// block; as many as the cells have nodes are used.
    std::array<std::vector<double>, (1u << dim)> shape_values;

    unsigned int begin = 0; ///< first point
    unsigned int end   = 0; ///< past the last point

    /// Makes this the block of runs that starts at point @p first.
    void
    reinit(const Points::PointArrays<dim> &points, const unsigned int first);
  };
} // namespace mpm_granular::Transfer

#endif
