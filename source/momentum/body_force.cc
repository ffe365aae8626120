#include <mpm_granular/momentum/body_force.h>

namespace mpm_granular::Momentum
{
  using namespace dealii;

  template <int dim>
  BodyForce<dim>::BodyForce()
  {
    gravity[dim - 1] = -9.81;
  }

  template <int dim>
  void
  BodyForce<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Gravity", gravity, "Force per mass. Units: m/s^2.");
    prm.add_parameter("Time factor",
                      factor,
                      "Factor on gravity, an expression of t. Units: -.");
  }

  template <int dim>
  void
  BodyForce<dim>::check() const
  {
    factor_expression.emplace(factor, 1, "Body force/Time factor");
  }

  template <int dim>
  Tensor<1, dim>
  BodyForce<dim>::value(const double time) const
  {
    return factor_expression->value(Point<dim>(), time) * gravity;
  }

  template class BodyForce<2>;
  template class BodyForce<3>;
} // namespace mpm_granular::Momentum
