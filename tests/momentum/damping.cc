// Damping of a mass on a spring against closed forms. Local: with the
// coefficient a the spring is (1 + a) times as stiff on the way out and (1 - a)
// times on the way back, so that half a period lasts pi/2 (1/sqrt(1 - a) +
// 1/sqrt(1 + a)) / omega and the amplitude falls by sqrt((1 - a)/(1 + a)).
// Viscous: free motion dies out as exp(-c t) whatever the step, an oscillation
// as exp(-c t/2).

#include <deal.II/base/parameter_handler.h>

#include <mpm_granular/momentum/damping.h>

#include <cmath>
#include <iostream>

using namespace dealii;
using namespace mpm_granular;

template <int dim>
std::unique_ptr<Momentum::Damping<dim>>
damping(const std::string &name, const std::string &entry)
{
  auto             result = Momentum::DampingRegistry<dim>::make(name);
  ParameterHandler prm;
  result->add_parameters(prm);
  prm.parse_input_from_string("set " + entry);
  return result;
}

/// A mass of 2 kg on a spring of 2 N/m, along the last axis: omega = 1/s.
template <int dim>
struct Oscillator
{
  std::unique_ptr<Momentum::Damping<dim>> damping;
  double                                  dt;
  double                                  place = 1., momentum = 0.;

  /// @return the impulse of damping in the step.
  double
  step()
  {
    Momentum::NodalVectors<dim> old(1), impulse(1), damped;
    old[0][dim - 1]     = momentum;
    impulse[0][dim - 1] = -2. * place * dt;
    damping->compute(dt, {}, old, impulse, damped);
    momentum += impulse[0][dim - 1] + damped[0][dim - 1];
    place += dt * momentum / 2.;
    return damped[0][dim - 1];
  }
};

template <int dim>
void
test()
{
  std::cout << dim << "D" << std::endl;
  for (const double a : {.3, .8})
    {
      Oscillator<dim> mass{
        damping<dim>("local", "Damping coefficient = " + std::to_string(a)),
        1e-4};
      double       time = 0.;
      unsigned int n    = 0;
      do
        {
          mass.step();
          time = ++n * mass.dt;
      } while (mass.momentum < 0.);
      const double half =
        numbers::PI_2 * (1. / std::sqrt(1. - a) + 1. / std::sqrt(1. + a));
      const double amplitude = std::sqrt((1. - a) / (1. + a));
      std::cout << "local, " << a << ": half a period over theory "
                << (std::abs(time / half - 1.) < 1e-3)
                << ", amplitude over theory "
                << (std::abs(-mass.place / amplitude - 1.) < 1e-3) << std::endl;
    }

  Oscillator<dim> mass{damping<dim>("viscous", "Damping rate = 0.2"), 1e-4};
  // From one return to the next, after a full period: exp(-c t/2).
  double       peak = 1., time = 0.;
  unsigned int n      = 0;
  bool         is_out = false;
  for (; !(is_out && mass.momentum <= 0.); ++n)
    {
      mass.step();
      is_out = is_out || mass.momentum > 0.;
    }
  peak = mass.place;
  time = n * mass.dt;
  std::cout << "viscous: amplitude over theory "
            << (std::abs(peak / std::exp(-.1 * time) - 1.) < 1e-3)
            << ", period over theory "
            << (std::abs(time / (2. * numbers::PI / std::sqrt(1. - .01)) - 1.) <
                1e-3)
            << std::endl;

  const auto viscous = damping<dim>("viscous", "Damping rate = 3");
  Momentum::NodalVectors<dim> momentum(1), none(1), impulse;
  momentum[0][0] = 5.;
  viscous->compute(2., {}, momentum, none, impulse);
  std::cout << "free, one long step: "
            << (momentum[0][0] + impulse[0][0]) / (5. * std::exp(-6.))
            << std::endl;

  // On a wall with the normal (0.6, -0.8) only the tangential parts count: of
  // the impulse (0, -1), which pushes into it, (-0.48, -0.36) is left; motion
  // down the wall is damped by half of it.
  Grid::VelocityConstraints<dim> wall;
  Grid::NodeConstraint<dim>      node;
  node.n_directions    = 1;
  node.direction[0][0] = .6;
  node.direction[0][1] = -.8;
  wall.nodes           = {node};
  none[0][1]           = -1.;
  momentum[0]          = none[0];
  const auto local     = damping<dim>("local", "Damping coefficient = 0.5");
  local->compute(1., wall, momentum, none, impulse);
  std::cout << "on a wall " << impulse[0] << std::endl;
  momentum[0] = 0.;
  local->compute(1., wall, momentum, none, impulse);
  std::cout << "without motion " << impulse[0] << std::endl;
}

int
main()
{
  test<2>();
  test<3>();
}
