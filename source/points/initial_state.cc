#include <mpm_granular/points/initial_state.h>

namespace mpm_granular::Points
{
  using namespace dealii;

  template <int dim>
  InitialState<dim>::InitialState()
    : stress("none")
  {}

  template <int dim>
  void
  InitialState<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Velocity",
                      velocity,
                      "Components of the velocity, expressions of x, y and z "
                      "separated by semicolons. Units: m/s.");
    stress.add_parameters(prm, "Stress", "The stress at the start:");
  }

  template <int dim>
  void
  InitialState<dim>::check() const
  {
    velocity_expression.emplace(velocity, dim, "Initial state/Velocity");
    stress->check();
  }

  template <int dim>
  void
  InitialState<dim>::apply(PointArrays<dim>     &points,
                           const std::size_t     p,
                           const double          density,
                           const Tensor<1, dim> &gravity) const
  {
    const Point<dim> place = points.location(p);
    for (unsigned int d = 0; d < dim; ++d)
      points.velocity[d][p] = velocity_expression->value(place, 0., d);
    const Stress<dim> initial = stress->stress(place, density, gravity);
    for (unsigned int s = 0; s < n_stress<dim>; ++s)
      points.stress[s][p] = initial[s];
  }

  template <int dim>
  Tensor<2, dim>
  InitialState<dim>::velocity_gradient(const Point<dim> &place,
                                       const double      length) const
  {
    Tensor<2, dim> gradient;
    for (unsigned int j = 0; j < dim; ++j)
      {
        Point<dim> behind = place, ahead = place;
        behind[j] -= .5 * length;
        ahead[j] += .5 * length;
        for (unsigned int i = 0; i < dim; ++i)
          gradient[i][j] = (velocity_expression->value(ahead, 0., i) -
                            velocity_expression->value(behind, 0., i)) /
                           (ahead[j] - behind[j]);
      }
    return gradient;
  }

  template struct InitialState<2>;
  template struct InitialState<3>;
} // namespace mpm_granular::Points
