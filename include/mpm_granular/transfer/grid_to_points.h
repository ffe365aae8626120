#ifndef mpm_granular_transfer_grid_to_points_h
#define mpm_granular_transfer_grid_to_points_h

#include <mpm_granular/grid/nodal_fields.h>
#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/mesh/partition.h>
#include <mpm_granular/transfer/point_block.h>

#include <limits>

namespace mpm_granular::Transfer
{
  /// Moves the points of a block with the grid (T13) and updates their
  /// velocities (T14). Shape values are then those of the new places, in the
  /// cells in which the points were.
  template <int dim>
  void
  move_points(const Mesh::BackgroundMesh<dim> &mesh,
              const Grid::NodalFields<dim>    &fields,
              PointBlock<dim>                 &block,
              const double                     time_step,
              const double                     pic_factor,
              Points::PointArrays<dim>        &points);

  /// Sets the block's velocity gradients from the straining velocity of the
  /// grid (T15).
  template <int dim>
  void
  evaluate_gradients(const Mesh::BackgroundMesh<dim> &mesh,
                     const Grid::NodalFields<dim>    &fields,
                     const Points::PointArrays<dim>  &points,
                     PointBlock<dim>                 &block);

  /// Sets the shape values of the block's points in their cells, in which they
  /// need not be any more.
  template <int dim>
  void
  find_shape_values(const Mesh::BackgroundMesh<dim> &mesh,
                    const Points::PointArrays<dim>  &points,
                    PointBlock<dim>                 &block);

  /// No point is lost.
  inline constexpr unsigned int no_point =
    std::numeric_limits<unsigned int>::max();

  /// What relocate() found.
  struct Relocation
  {
    /// The first point that has left the mesh (its cell is Mesh::no_cell).
    unsigned int lost_point = no_point;

    /// Whether a point has come to a cell that is out of this rank's reach.
    bool is_out_of_reach = false;

    void
    operator+=(const Relocation &other);
  };

  /// Finds the host cells of the block's points at their new places, and the
  /// shape values of those that have left their cells. The shape values in the
  /// old cells must be set (move_points() or find_shape_values()).
  template <int dim>
  Relocation
  relocate(const Mesh::BackgroundMesh<dim> &mesh,
           const Mesh::Partition<dim>      &partition,
           Points::PointArrays<dim>        &points,
           PointBlock<dim>                 &block);
} // namespace mpm_granular::Transfer

#endif
