#ifndef mpm_granular_solver_sweep_h
#define mpm_granular_solver_sweep_h

#include <mpm_granular/grid/nodal_fields.h>
#include <mpm_granular/materials/constitutive_law.h>
#include <mpm_granular/materials/stress_update.h>
#include <mpm_granular/points/motion.h>
#include <mpm_granular/transfer/averaging.h>
#include <mpm_granular/transfer/grid_to_points.h>
#include <mpm_granular/transfer/point_block.h>
#include <mpm_granular/transfer/pressure_filter.h>
#include <mpm_granular/transfer/settled_pressures.h>
#include <mpm_granular/transfer/velocity_update.h>

#include <vector>

namespace mpm_granular::Solver
{
  /// What a sweep over the points found.
  struct SweepResult
  {
    Points::Motion       motion;          ///< after the step
    double               dissipated = 0.; ///< by the laws [J]
    Transfer::Relocation relocation;      ///< what became of the points' cells
    std::size_t          n_runs = 0;      ///< of points in the same cell
  };

  /**
   * The one pass over the points of a time step. It goes block by block, so
   * that the points of a block stay in the nearest caches from reading them
   * once to writing them once, while grid to points, law, walk and points to
   * grid each do their part.
   */
  template <int dim>
  class Sweep
  {
  public:
    /// @param laws by material index; like the others, must live as long.
    Sweep(const Mesh::BackgroundMesh<dim>                            &mesh,
          const Mesh::Partition<dim>                                 &partition,
          const std::vector<const Materials::ConstitutiveLaw<dim> *> &laws,
          Transfer::Averaging<dim>                                   &averaging,
          const Transfer::VelocityUpdate<dim>   &velocity_update,
          const Transfer::SettledPressures<dim> &settled_pressures);

    /// Sums the points as they are to the cells: before the first step, and
    /// whenever the points have changed outside of a step.
    SweepResult
    project(Points::PointArrays<dim> &points, Grid::NodalFields<dim> &fields);

    /// Moves and strains the points with the grid's velocities and sums them to
    /// their new cells (USL, MUSL).
    SweepResult
    advance(Points::PointArrays<dim> &points,
            Grid::NodalFields<dim>   &fields,
            const double              time_step,
            const double              pic_factor);

    /// Strains the points where they are and sums their stresses to their
    /// cells: the first of two passes of USF.
    /// @return energy dissipated by the laws [J].
    double
    strain(Points::PointArrays<dim> &points,
           Grid::NodalFields<dim>   &fields,
           const double              time_step);

    /// Moves the points with the grid's velocities and sums mass and momentum
    /// to their new cells: the second pass of USF.
    SweepResult
    move(Points::PointArrays<dim> &points,
         Grid::NodalFields<dim>   &fields,
         const double              time_step,
         const double              pic_factor);

    /// Makes the pressures of the points smooth (T29) and sums their stresses
    /// to their cells again. The points must be where the active nodes of
    /// @p fields were gathered.
    /// @param time since this was last done [s].
    /// @return elastic energy taken out of the points [J].
    double
    smooth_pressures(Points::PointArrays<dim> &points,
                     Grid::NodalFields<dim>   &fields,
                     const double              time);

    /// Lets smooth_pressures() leave the present pressures as they are until
    /// the points have moved on (T29a).
    void
    settle_pressures(Points::PointArrays<dim> &points,
                     Grid::NodalFields<dim>   &fields);

  private:
    /// Calls @p action for every block of points.
    template <class Action>
    void
    for_each_block(Points::PointArrays<dim> &points, Action &&action);

    /// Forgets all sums over the points.
    void
    clear(Grid::NodalFields<dim> &fields);

    /// Forgets the sums of their stresses.
    void
    clear_stresses(Grid::NodalFields<dim> &fields);

    /// Finds the new cells of the block's points and sums mass and momentum to
    /// them.
    void
    relocate_and_sum(Points::PointArrays<dim> &points,
                     Grid::NodalFields<dim>   &fields,
                     SweepResult              &result);

    /// Sets the block's shape values, where its points have not moved.
    void
    find_shape_values(Points::PointArrays<dim> &points);

    /// Calls @p action(law, first, last) for runs [first, last) of points of
    /// one law.
    template <class Action>
    void
    for_each_law(const Points::PointArrays<dim> &points,
                 const std::vector<Points::Run> &runs,
                 Action                        &&action);

    /// Makes the filter know the pressures of all points.
    void
    sum_pressures(Points::PointArrays<dim> &points,
                  Grid::NodalFields<dim>   &fields);

    /// Updates the stresses of the block, law by law.
    double
    update_stresses(Points::PointArrays<dim> &points, const double time_step);

    const Mesh::BackgroundMesh<dim>                            &mesh;
    const Mesh::Partition<dim>                                 &partition;
    const std::vector<const Materials::ConstitutiveLaw<dim> *> &laws;
    Transfer::Averaging<dim>                                   &averaging;
    const Transfer::VelocityUpdate<dim>                        &velocity_update;
    const Transfer::SettledPressures<dim> &settled_pressures;
    Transfer::PointBlock<dim>              block;
    Transfer::PressureFilter<dim>          filter;
    /// Of the points of the block [Pa].
    typename Transfer::PointBlock<dim>::Array smooth_pressure = {};
  };
} // namespace mpm_granular::Solver

#endif
