#ifndef mpm_granular_transfer_pressure_filter_h
#define mpm_granular_transfer_pressure_filter_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <mpm_granular/grid/nodal_fields.h>
#include <mpm_granular/transfer/point_block.h>

#include <array>
#include <vector>

namespace mpm_granular::Transfer
{
  /**
   * A smooth pressure for the points in contact (p > 0), from the mean pressure
   * around each node and its gradient (T29). A pressure that is linear in space
   * comes back as it is, so a geostatic state stays untouched.
   *
   * There are more points than nodes, so that some patterns of pressure act on
   * no node and are never corrected by the motion; giving the points the
   * smooth pressure removes them.
   *
   * Use: reinit(), add() all runs of points, find_gradients(), evaluate().
   */
  template <int dim>
  class PressureFilter
  {
  public:
    explicit PressureFilter(const Mesh::BackgroundMesh<dim> &mesh);

    /// Starts anew on the active cells and nodes of @p fields, which must
    /// belong to the present places of the points.
    void
    reinit(const Grid::NodalFields<dim> &fields);

    /// Takes in the points of a run of the block, whose shape values must be
    /// those at their places.
    void
    add(const Grid::NodalFields<dim>   &fields,
        const Points::PointArrays<dim> &points,
        const PointBlock<dim>          &block,
        const Points::Run               run);

    /// Makes means and gradients of what has been added on all ranks.
    void
    find_gradients(Grid::NodalFields<dim> &fields);

    /// The smooth pressure [Pa], 0 or more, at the points of a block: entry i
    /// is that of point block.begin + i. Meaningful for points in contact.
    void
    evaluate(const Grid::NodalFields<dim>    &fields,
             const Points::PointArrays<dim>  &points,
             const PointBlock<dim>           &block,
             typename PointBlock<dim>::Array &smooth_pressure) const;

  private:
    /// Gradients of the pressure at the nodes of a cell, given by their slots
    /// [Pa/m].
    template <class Slots>
    auto
    gradients_at(const Slots &slots) const;

    /// Of a node, sums over the points in contact around it, weighted by N_ip
    /// V_p; then their means, but for the volume.
    enum Mean
    {
      volume,   ///< [m^3], in 2D [m^2]
      pressure, ///< [Pa]
      center,   ///< [m], dim numbers
      n_means = center + dim
    };

    /// Of a node, the mean gradient of the pressure in the cells around it.
    enum Slope
    {
      weight,   ///< volume in contact [m^3], in 2D [m^2]
      gradient, ///< [Pa/m], dim numbers
      n_slopes = gradient + dim
    };

    const Mesh::BackgroundMesh<dim>          &mesh;
    std::vector<std::array<double, n_means>>  means;  ///< by node slot
    std::vector<std::array<double, n_slopes>> slopes; ///< by node slot
    std::vector<double> cell_volume; ///< in contact, by cell slot
  };
} // namespace mpm_granular::Transfer

#endif
