#include <mpm_granular/grid/velocity_constraints.h>

namespace mpm_granular::Grid
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    void
    add_direction(NodeConstraint<dim>  &constraint,
                  const Tensor<1, dim> &direction,
                  const double          target)
    {
      constraint.direction[constraint.n_directions] = direction;
      constraint.target[constraint.n_directions]    = target;
      ++constraint.n_directions;
    }



    /// The part of a vector that no direction of the constraint is along.
    template <int dim>
    Tensor<1, dim>
    free_part(const NodeConstraint<dim> &constraint, Tensor<1, dim> vector)
    {
      for (unsigned int k = 0; k < constraint.n_directions; ++k)
        vector -= (constraint.direction[k] * vector) * constraint.direction[k];
      return vector;
    }



    /// Prescribes that the other components are zero.
    template <int dim>
    void
    hold_the_rest(NodeConstraint<dim> &constraint)
    {
      for (unsigned int d = 0; d < dim; ++d)
        {
          Tensor<1, dim> axis;
          axis[d]                   = 1.;
          const Tensor<1, dim> rest = free_part(constraint, axis);
          // Of a free direction some axis has a part of more than 1/sqrt(dim).
          if (constraint.n_directions < dim && rest.norm() > .5)
            add_direction(constraint, rest / rest.norm(), 0.);
        }
    }
  } // namespace

  template <int dim>
  VelocityConstraints<dim>
  VelocityConstraints<dim>::resolve_contact(
    std::vector<Tensor<1, dim>> &velocity) const
  {
    VelocityConstraints<dim> result;
    for (const auto &node : nodes)
      {
        Tensor<1, dim>     &v = velocity[node.slot];
        NodeConstraint<dim> held;
        held.slot   = node.slot;
        double grip = 0.; // the speed that friction can stop
        for (unsigned int k = 0; k < node.n_directions; ++k)
          {
            const double excess = node.direction[k] * v - node.target[k];
            if (node.contact_friction[k] && excess <= 0.)
              continue;
            v -= excess * node.direction[k];
            add_direction(held, node.direction[k], node.target[k]);
            grip += node.contact_friction[k].value_or(0.) * excess;
          }
        if (grip > 0.)
          {
            const Tensor<1, dim> sliding = free_part(held, v);
            const double         speed   = sliding.norm();
            v -= (speed > grip ? grip / speed : 1.) * sliding;
            if (speed <= grip)
              hold_the_rest(held);
          }
        if (held.n_directions > 0)
          result.nodes.push_back(held);
      }
    return result;
  }

  template class VelocityConstraints<2>;
  template class VelocityConstraints<3>;
} // namespace mpm_granular::Grid
