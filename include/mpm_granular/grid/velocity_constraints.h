#ifndef mpm_granular_grid_velocity_constraints_h
#define mpm_granular_grid_velocity_constraints_h

#include <deal.II/base/tensor.h>

#include <array>
#include <optional>
#include <vector>

namespace mpm_granular::Grid
{
  /// Prescribed velocity components of one active node.
  template <int dim>
  struct NodeConstraint
  {
    unsigned int slot         = 0; ///< of the node
    unsigned int n_directions = 0; ///< how many of the following are used

    std::array<dealii::Tensor<1, dim>, dim> direction; ///< orthonormal
    std::array<double, dim>                 target{};  ///< along it [m/s]

    /// Where a wall pushes against the direction, but does not pull: the
    /// coefficient of its friction. Such walls are at rest.
    std::array<std::optional<double>, dim> contact_friction{};
  };

  /// The prescribed velocity components of all active nodes, now.
  template <int dim>
  class VelocityConstraints
  {
  public:
    std::vector<NodeConstraint<dim>> nodes;

    bool has_contact = false; ///< any wall, on any rank, only pushes

    /**
     * Lets the walls act on the velocities that the nodes would have without
     * them (T34): prescribed components get their values; walls that only push
     * stop what moves into them, and friction what slides along them.
     *
     * @return what this leaves prescribed in the step: the normal component
     *   where a wall pushes, all components where friction holds the node.
     */
    VelocityConstraints
    resolve_contact(std::vector<dealii::Tensor<1, dim>> &velocity) const;

    /// Gives the constrained components their prescribed values. Without
    /// contact, or with that of resolve_contact().
    template <class Field>
    void
    apply(Field &velocity) const
    {
      for (const auto &node : nodes)
        for (unsigned int k = 0; k < node.n_directions; ++k)
          velocity[node.slot] +=
            (node.target[k] - node.direction[k] * velocity[node.slot]) *
            node.direction[k];
    }

    /// Removes the constrained components: the projection on admissible
    /// variations, for walls that only push as if they held.
    template <class Field>
    void
    project(Field &field) const
    {
      for (const auto &node : nodes)
        for (unsigned int k = 0; k < node.n_directions; ++k)
          field[node.slot] -=
            (node.direction[k] * field[node.slot]) * node.direction[k];
    }
  };
} // namespace mpm_granular::Grid

#endif
