#ifndef mpm_granular_transfer_velocity_update_h
#define mpm_granular_transfer_velocity_update_h

#include <mpm_granular/core/registry.h>
#include <mpm_granular/grid/nodal_fields.h>
#include <mpm_granular/grid/velocity_constraints.h>
#include <mpm_granular/parameters/parameter_group.h>
#include <mpm_granular/transfer/point_block.h>

#include <string>
#include <vector>

namespace mpm_granular::Transfer
{
  /// One vector per active node, by slot.
  template <int dim>
  using NodalVectors = std::vector<dealii::Tensor<1, dim>>;

  /// The velocities of the active nodes in a step (T12) [m/s].
  template <int dim>
  struct NodalVelocities
  {
    const NodalVectors<dim>              &old_velocity; ///< of the points
    const NodalVectors<dim>              &new_velocity; ///< admissible
    const Grid::VelocityConstraints<dim> &constraints;  ///< of the new ones
  };

  /**
   * How points take their velocity from the grid and hand it on (T14, T65 to
   * T69). A point keeps the part 1 - c of its velocity and adds a nodal field,
   * the change, interpolated to its place.
   *
   * In a step: find_motion() when the velocities of the nodes are known,
   * add_momentum() for the re-mapped velocity; then for every block of points
   * take() before they move and give() when they are in their new cells.
   */
  template <int dim>
  class VelocityUpdate : public Parameters::ParameterGroup
  {
  public:
    /// Whether the lumped mass matrix is a part of the scheme.
    virtual bool
    needs_lumped_mass() const
    {
      return false;
    }

    /// Whether constraints may be walls that push only.
    virtual bool
    handles_contact() const
    {
      return true;
    }

    /// Whether stresses may be updated before the velocities are known (USF).
    virtual bool
    handles_stress_first() const
    {
      return true;
    }

    /// Whether the gradients must be means around nodes for it to be stable.
    virtual bool
    needs_means_of_gradients() const
    {
      return false;
    }

    /// Whether shape functions may reach beyond the cells of the points.
    virtual bool
    handles_wide_functions() const
    {
      return true;
    }

    /// Names of the numbers that each point keeps for the scheme.
    virtual std::vector<std::string>
    history_names() const
    {
      return {};
    }

    /// Tells the scheme that its numbers begin at PointArrays::history[slot].
    void
    set_first_slot(const unsigned int slot)
    {
      first_slot = slot;
    }

    /// Sets the scheme's numbers of point @p p.
    /// @param gradient of the velocity there [1/s].
    virtual void
    initialize(Points::PointArrays<dim> & /*points*/,
               const std::size_t /*p*/,
               const dealii::Tensor<2, dim> & /*gradient*/) const
    {}

    /// The part c of the points' velocity that is replaced in a step (T14).
    /// @param time_step [s].
    virtual double
    pic_factor(const double time_step) const = 0;

    /**
     * Sets NodeMotion::velocity, with which points move, and
     * NodeMotion::change, which they add to the part 1 - c of their velocity.
     * By default the new velocity, and v' - (1 - c) v. Collective.
     *
     * @param time_step [s].
     */
    virtual void
    find_motion(const NodalVelocities<dim> &velocities,
                const double                time_step,
                Grid::NodalFields<dim>     &fields);

    /**
     * Adds to @p momentum, which is the part 1 - c of the points' old momentum
     * at the nodes, what makes it the new momentum that the points, still at
     * their old places, give to the nodes. By default the sampled consistent
     * mass matrix times the change (T16). Collective.
     */
    virtual void
    add_momentum(Grid::NodalFields<dim> &fields,
                 NodalVectors<dim>      &momentum) const;

    /// Sets the scheme's numbers of a block's points, which have not moved yet,
    /// from the block's gradients (T15). Not in a stage where points stay.
    virtual void
    take(const PointBlock<dim> & /*block*/,
         Points::PointArrays<dim> & /*points*/) const
    {}

    /// Adds momentum of the block's points besides m v to the sums of their
    /// cells, which are active; with the block's shape values.
    virtual void
    give(const Mesh::BackgroundMesh<dim> & /*mesh*/,
         const Points::PointArrays<dim> & /*points*/,
         const PointBlock<dim> & /*block*/,
         Grid::NodalFields<dim> & /*fields*/) const
    {}

  protected:
    /// Hands the change over to the points.
    void
    set_change(Grid::NodalFields<dim> &fields) const;

    NodalVectors<dim> change;         ///< [m/s]
    unsigned int      first_slot = 0; ///< of PointArrays::history
  };

  template <int dim>
  using VelocityUpdateRegistry = Core::Registry<VelocityUpdate<dim>>;
} // namespace mpm_granular::Transfer

#endif
