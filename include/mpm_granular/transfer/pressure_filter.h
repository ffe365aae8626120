#ifndef mpm_granular_transfer_pressure_filter_h
#define mpm_granular_transfer_pressure_filter_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <mpm_granular/grid/nodal_fields.h>
#include <mpm_granular/points/point_arrays.h>

#include <vector>

namespace mpm_granular::Transfer
{
  /**
   * A smooth pressure for the points in contact (p > 0), from the mean pressure
   * around each node and its gradient (T29). A pressure that is linear in space
   * comes back as it is, so a geostatic state stays untouched.
   *
   * There are more points than nodes, so that some patterns of pressure act on
   * no node and are never corrected by the motion; relaxing the points to the
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

    /// Takes in the points of a run.
    void
    add(const Grid::NodalFields<dim>   &fields,
        const Points::PointArrays<dim> &points,
        const Points::Run               run);

    /// Makes means and gradients of what has been added.
    void
    find_gradients(const Grid::NodalFields<dim> &fields);

    /// The smooth pressure [Pa], 0 or more, at the points of a run: entry i is
    /// that of point run.begin + i. Meaningful for points in contact.
    void
    evaluate(const Grid::NodalFields<dim>   &fields,
             const Points::PointArrays<dim> &points,
             const Points::Run               run,
             std::vector<double>            &pressure) const;

  private:
    /// Sums over the points in contact around a node, weighted by N_ip V_p;
    /// then their means.
    struct Node
    {
      double                 volume   = 0.;        ///< [m^3], in 2D [m^2]
      double                 pressure = 0.;        ///< [Pa]
      dealii::Point<dim>     center;               ///< [m]
      dealii::Tensor<1, dim> gradient;             ///< of pressure [Pa/m]
      double                 gradient_volume = 0.; ///< of the cells in gradient
    };

    const Mesh::BackgroundMesh<dim> &mesh;
    std::vector<Node>                nodes;       ///< by node slot
    std::vector<double>              cell_volume; ///< in contact, by cell slot
  };
} // namespace mpm_granular::Transfer

#endif
