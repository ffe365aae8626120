#ifndef mpm_granular_transfer_averaging_h
#define mpm_granular_transfer_averaging_h

#include <mpm_granular/core/archive.h>
#include <mpm_granular/core/registry.h>
#include <mpm_granular/grid/nodal_fields.h>
#include <mpm_granular/mesh/partition.h>
#include <mpm_granular/parameters/parameter_group.h>
#include <mpm_granular/transfer/filling.h>
#include <mpm_granular/transfer/grid_to_points.h>
#include <mpm_granular/transfer/point_block.h>
#include <mpm_granular/transfer/points_to_grid.h>

#include <string>
#include <vector>

namespace mpm_granular::Transfer
{
  /// Below so many points per filled cell, on average, a cell by itself says
  /// little: its neighbours have to count as well.
  constexpr double few_points_per_cell = 3.;

  /// What suits a body depends on it.
  struct BodyTraits
  {
    double points_per_cell;  ///< mean of the cells that are filled
    bool   is_granular;      ///< whether any of its laws is one of grains
    bool   is_settled_first; ///< in a stage of initial equilibrium
  };

  /**
   * How the stresses of points become forces of nodes, and the velocities of
   * nodes become velocity gradients of points: from the cell of each point
   * alone, or as means over what is around (section 2 of doc/theory.md). One
   * with shape functions of its own also does what these are for: it sums
   * masses and momenta and moves the points.
   *
   * In a step: clear(), add_mass_and_momentum(), add_volumes() and
   * add_stresses() of every block of points, find_weights() on the active
   * nodes, find_forces(); and when the velocities are known, find_gradients(),
   * and evaluate() and move_points() every block.
   */
  template <int dim>
  class Averaging : public Parameters::ParameterGroup
  {
  public:
    /**
     * Makes what depends on the body suit it; called once, before the first
     * step.
     *
     * @return whether reinit() has to be called again.
     */
    virtual bool
    suit(const BodyTraits & /*body*/)
    {
      return false;
    }

    /// The name of what is used, where the chosen one, @p chosen_name, leaves
    /// that open.
    virtual std::string
    name_in_use(const std::string &chosen_name) const
    {
      return chosen_name;
    }

    /// The rate of the pressure filter that goes well with these averages, in
    /// wave speeds over cell size; after suit().
    virtual double
    suitable_filter_rate() const = 0;

    /// The rate of the position shift that does [1/s]; after suit().
    virtual double
    suitable_shift_rate() const
    {
      return 0.;
    }

    /**
     * Prepares for a mesh, or for its new cells.
     *
     * @param largest_specific_volume by material, volume per mass up to which a
     *   point counts as filled [m^3/kg]; what is beyond is gaps.
     * @throws InputError if this cannot be done on such a mesh.
     */
    virtual void
    reinit(const Mesh::BackgroundMesh<dim> &mesh,
           const Mesh::Partition<dim>      &partition,
           const std::vector<double>       &largest_specific_volume) = 0;

    /// Whether shape functions are its own and reach beyond the cells of the
    /// points, to the nodes of the cells around them.
    virtual bool
    reaches_beyond_cells() const
    {
      return false;
    }

    /// Forgets the sums over the points.
    virtual void
    clear()
    {}

    /// Forgets the sums of stresses only.
    virtual void
    clear_stresses()
    {}

    /// Adds mass and momentum of a block's points to the sums of their host
    /// cells, which become active (T9).
    virtual void
    add_mass_and_momentum(const Mesh::BackgroundMesh<dim> &mesh,
                          const Points::PointArrays<dim>  &points,
                          const PointBlock<dim>           &block,
                          Grid::NodalFields<dim>          &fields)
    {
      Transfer::add_mass_and_momentum(mesh, points, block, fields);
    }

    /// Adds the volumes of a block's points to the sums of their host cells,
    /// which are active; with the block's shape values.
    virtual void
    add_volumes(const Points::PointArrays<dim> & /*points*/,
                const PointBlock<dim> & /*block*/,
                const Grid::NodalFields<dim> & /*fields*/)
    {}

    /// The same for the stresses of the block's points.
    virtual void
    add_stresses(const Points::PointArrays<dim> &points,
                 const PointBlock<dim>          &block,
                 Grid::NodalFields<dim>         &fields) = 0;

    /// Finds from the volumes what counts how much.
    virtual void
    find_weights(Grid::NodalFields<dim> & /*fields*/)
    {}

    /// How full of material the surroundings of nodes are, after
    /// find_weights(); nullptr if nothing is averaged around nodes.
    virtual const Filling<dim> *
    filling_of_nodes() const
    {
      return nullptr;
    }

    /// Whether find_forces() does not need the forces that are summed from the
    /// cells, but sets them.
    virtual bool
    sets_forces() const
    {
      return false;
    }

    /// Completes the internal forces of the nodes, which have been summed from
    /// the cells as add_stresses() left them (T9).
    virtual void
    find_forces(Grid::NodalFields<dim> & /*fields*/)
    {}

    /// Prepares the gradients of NodeMotion::straining.
    virtual void
    find_gradients(Grid::NodalFields<dim> & /*fields*/)
    {}

    /// Sets the velocity gradients of a block.
    virtual void
    evaluate(const Grid::NodalFields<dim>   &fields,
             const Points::PointArrays<dim> &points,
             PointBlock<dim>                &block) const = 0;

    /// Moves the points of a block with the grid and updates their velocities,
    /// see Transfer::move_points().
    virtual void
    move_points(const Mesh::BackgroundMesh<dim> &mesh,
                const Grid::NodalFields<dim>    &fields,
                PointBlock<dim>                 &block,
                const double                     time_step,
                const double                     pic_factor,
                Points::PointArrays<dim>        &points) const
    {
      Transfer::move_points(mesh, fields, block, time_step, pic_factor, points);
    }

    /**
     * The power of the nodal forces on the straining velocities, less that of
     * the stresses of the points on their gradients [W]: this rank's part of
     * what the motion loses because one is not the exact adjoint of the other
     * (T28d). After find_gradients().
     */
    virtual double
    lost_power(const Grid::NodalFields<dim> & /*fields*/) const
    {
      return 0.;
    }

    /// The sums over the points, for checkpoints.
    virtual void
    serialize(Core::Archive & /*archive*/)
    {}
  };

  template <int dim>
  using AveragingRegistry = Core::Registry<Averaging<dim>>;
} // namespace mpm_granular::Transfer

#endif
