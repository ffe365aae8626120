#ifndef mpm_granular_transfer_settled_pressures_h
#define mpm_granular_transfer_settled_pressures_h

#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/points/point_arrays.h>
#include <mpm_granular/transfer/point_block.h>

#include <string>
#include <vector>

namespace mpm_granular::Transfer
{
  /**
   * By how much the pressures of points in the initial equilibrium (T35) differ
   * from smooth ones. Where points do not fill the cells evenly the balance of
   * forces needs these differences, so that the pressure filter leaves them
   * (T29a); they fade as the points come to other places in the mesh.
   */
  template <int dim>
  class SettledPressures
  {
  public:
    using Array = typename PointBlock<dim>::Array;

    /**
     * @param first_slot of PointArrays::history, where the differences are
     *   kept [Pa].
     * @param is_wanted whether there will be an initial equilibrium; otherwise
     *   nothing is kept.
     */
    SettledPressures(const Mesh::BackgroundMesh<dim> &mesh,
                     const unsigned int               first_slot,
                     const bool                       is_wanted);

    /// Names of the numbers that each point keeps.
    static std::vector<std::string>
    history_names(const bool is_wanted);

    /// Keeps the differences of a block's points from @p smooth_pressure [Pa],
    /// of which entry i is that of point block.begin + i.
    void
    keep(Points::PointArrays<dim> &points,
         const PointBlock<dim>    &block,
         const Array              &smooth_pressure) const;

    /// Adds what is left of them after another @p time [s] of motion.
    void
    add(Points::PointArrays<dim> &points,
        const PointBlock<dim>    &block,
        const double              time,
        Array                    &smooth_pressure) const;

  private:
    const Mesh::BackgroundMesh<dim> &mesh;
    const unsigned int               slot;
    const bool                       is_wanted;
  };
} // namespace mpm_granular::Transfer

#endif
