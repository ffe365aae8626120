#ifndef mpm_granular_transfer_points_to_grid_h
#define mpm_granular_transfer_points_to_grid_h

#include <mpm_granular/grid/nodal_fields.h>
#include <mpm_granular/transfer/point_block.h>

namespace mpm_granular::Transfer
{
  /**
   * Adds mass and momentum of the block's points to the sums of their host
   * cells (T9), with the block's shape values and parts. Points whose cell is
   * Mesh::no_cell are left out.
   */
  template <int dim>
  void
  add_mass_and_momentum(const Mesh::BackgroundMesh<dim> &mesh,
                        const Points::PointArrays<dim>  &points,
                        const PointBlock<dim>           &block,
                        Grid::NodalFields<dim>          &fields);

  /// Adds V sigma of the block's points, or the forces that follow from it, to
  /// the sums of their host cells (T9).
  template <int dim>
  void
  add_stress(const Mesh::BackgroundMesh<dim> &mesh,
             const Points::PointArrays<dim>  &points,
             const PointBlock<dim>           &block,
             Grid::NodalFields<dim>          &fields);
} // namespace mpm_granular::Transfer

#endif
