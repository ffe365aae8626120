#ifndef mpm_granular_boundary_boundary_manager_h
#define mpm_granular_boundary_boundary_manager_h

#include <mpm_granular/boundary/boundary_condition.h>
#include <mpm_granular/grid/nodal_fields.h>
#include <mpm_granular/grid/velocity_constraints.h>
#include <mpm_granular/parameters/choice.h>

#include <string>
#include <vector>

namespace mpm_granular::Boundary
{
  /// A condition of the parameter file and the boundaries it is for.
  template <int dim>
  struct BoundarySetting : Parameters::ParameterGroup
  {
    BoundarySetting();

    std::vector<std::string>                   boundaries;
    Parameters::Choice<BoundaryCondition<dim>> condition;

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;
  };

  template <int dim>
  using BoundarySettings = Parameters::NamedGroups<BoundarySetting<dim>>;

  /**
   * Brings the boundary conditions to the active nodes.
   *
   * Where several conditions meet at a node, their directions are made
   * orthonormal in the order of the parameter file: all of them hold exactly
   * where they do not contradict, the first one where they do.
   */
  template <int dim>
  class BoundaryManager
  {
  public:
    /// @param settings must live as long.
    /// @throws InputError for unknown boundaries, and boundaries without a
    /// condition.
    BoundaryManager(const BoundarySettings<dim>     &settings,
                    const Mesh::BackgroundMesh<dim> &mesh,
                    const MPI_Comm                   communicator);

    /// Finds the nodes again, for new cells of the mesh. Collective.
    void
    reinit();

    /// Whether any wall only pushes.
    bool
    has_contact() const
    {
      return active.has_contact;
    }

    /// Finds the constraints of the nodes that are active now, with their
    /// values for the step from @p time to @p time + @p time_step.
    void
    update(const Grid::NodalFields<dim> &fields,
           const double                  time,
           const double                  time_step);

    /// The same with all walls at rest.
    void
    update_at_rest(const Grid::NodalFields<dim> &fields);

    const Grid::VelocityConstraints<dim> &
    constraints() const
    {
      return active;
    }

    /// Adds the tractions at @p time to NodeSums::load, on faces whose cells
    /// hold points. Collective.
    void
    add_tractions(Grid::NodalFields<dim> &fields, const double time) const;

  private:
    /// A direction of a node before it is made orthogonal to the ones before.
    struct Direction
    {
      const BoundaryCondition<dim> *condition;
      dealii::Tensor<1, dim>        given;
    };

    struct Node
    {
      unsigned int              node;
      std::vector<Direction>    directions;
      bool                      moves = false; ///< or its targets stay zero
      Grid::NodeConstraint<dim> constraint;    ///< but for slot and targets
    };

    struct LoadedFace
    {
      const BoundaryCondition<dim> *condition;
      Mesh::BoundaryFace<dim>       face;
    };

    /// Finds the constraints of the active nodes; @p set_targets is called for
    /// those whose walls move.
    template <class SetTargets>
    void
    find_active(const Grid::NodalFields<dim> &fields, SetTargets &&set_targets);
    void
    set_targets(Node &node, const double time, const double time_step) const;

    /// For each loaded face, whether this rank is the first with points there.
    std::vector<bool>
    is_first_in_cells(const Grid::NodalFields<dim> &fields) const;

    const BoundarySettings<dim>     &settings;
    const Mesh::BackgroundMesh<dim> &mesh;
    const MPI_Comm                   communicator;
    std::vector<Node>                nodes;
    std::vector<unsigned int>        entry_of_node; ///< into nodes, or none
    std::vector<LoadedFace>          loaded_faces;
    bool                             has_loads = false; ///< on any rank
    Grid::VelocityConstraints<dim>   active;
  };
} // namespace mpm_granular::Boundary

#endif
