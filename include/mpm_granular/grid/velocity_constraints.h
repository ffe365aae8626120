#ifndef mpm_granular_grid_velocity_constraints_h
#define mpm_granular_grid_velocity_constraints_h

#include <deal.II/base/tensor.h>

#include <array>
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
  };

  /// The prescribed velocity components of all active nodes, now.
  template <int dim>
  class VelocityConstraints
  {
  public:
    std::vector<NodeConstraint<dim>> nodes;

    /// Gives the constrained components their prescribed values.
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
    /// variations.
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
