// Energy of a closed strain path: the work of the mean stress of each step is
// the change of the elastic energy plus what the law reports as released
// (T28b), at any step, but for the change of the volume and the rotation during
// a step and for terms of the order p/K, both below 1e-6 in stiff material.
// Nothing is released in an elastic path.

#include "single_point.h"

using namespace Test;

const std::string stiff         = "Young modulus=1e10"; // Poisson ratio 0.3
constexpr double  shear_modulus = 1e10 / 2.6;

/// Work, elastic energy gained, energy released in a cycle, and what plastic
/// flow without elasticity and viscosity would take: m p times the equivalent
/// strain.
struct Balance
{
  double work = 0., stored = 0., released = 0., plastic = 0.;
};

template <int dim>
double
power(const Stress<dim> &stress, const Tensor<2, dim> &gradient)
{
  double result = 0.;
  for (unsigned int c = 0; c < n_stress<dim>; ++c)
    {
      const unsigned int i = stress_index[c][0], j = stress_index[c][1];
      if (i < dim && j < dim)
        result += (i == j ? 1. : 2.) * stress[c] * .5 *
                  (gradient[i][j] + gradient[j][i]);
    }
  return result;
}

/// sqrt(2/3 e:e) of the deviator e of the strain rate.
template <int dim>
double
equivalent_rate(const Tensor<2, dim> &gradient)
{
  const Tensor<2, dim> rate = .5 * (gradient + transpose(gradient));
  // e:e = d:d - (tr d)^2/3.
  return std::sqrt(2. / 3. *
                   (rate.norm_square() - std::pow(trace(rate), 2) / 3.));
}

/// A cycle of shear with a smaller one of volume, of period 1 s.
template <int dim>
Balance
cycle(const std::string              &law,
      const std::vector<std::string> &entries,
      const double                    amplitude,
      const unsigned int              n_steps)
{
  SinglePoint<dim> point(law, entries, pressure_and_shear<dim>(1e5, 0.));
  const auto       energy = [&] {
    return point.volume() * point.law->elastic_energy_density(point.stress());
  };
  Balance      balance;
  const double time_step = 1. / n_steps, before = energy();
  for (unsigned int n = 0; n < n_steps; ++n)
    {
      const double   phase = 2. * numbers::PI * (n + .5) / n_steps;
      Tensor<2, dim> gradient =
        simple_shear<dim>(2. * numbers::PI * amplitude * std::cos(phase));
      gradient[dim - 1][0] += numbers::PI * amplitude * std::sin(phase);
      for (unsigned int d = 0; d < dim; ++d)
        gradient[d][d] -= .02 * amplitude * std::sin(phase);
      const double old_power = point.volume() * power(point.stress(), gradient);
      balance.released += point.step(gradient, time_step);
      const double new_power = point.volume() * power(point.stress(), gradient);
      balance.work += .5 * (old_power + new_power) * time_step;
      balance.plastic += 36. / 35. * point.pressure() *
                         equivalent_rate<dim>(gradient) * time_step;
    }
  balance.stored = energy() - before;
  return balance;
}

template <int dim>
void
test_elastic(const std::string &law, const double amplitude)
{
  const Balance balance = cycle<dim>(law, {stiff}, amplitude, 2000);
  std::cout << law << ", " << dim << "D, elastic" << std::endl;
  // Hypoelastic work and the current volume leave a part of the order of the
  // strain.
  compare("  work less gain",
          balance.work - balance.stored,
          0.,
          10. * amplitude,
          shear_modulus * amplitude * amplitude);
  compare("  released", balance.released, 0., 0., 1.);
}

template <int dim>
void
test_flow(const std::string &law, const std::vector<std::string> &entries)
{
  std::cout << law << ", " << dim << "D, " << entries.front() << std::endl;
  auto all = entries;
  all.insert(all.begin(), stiff);
  Balance balance;
  for (const unsigned int n_steps : {100, 2000})
    {
      balance = cycle<dim>(law, all, 1e-3, n_steps);
      compare("  work less gain and release in " + std::to_string(n_steps) +
                " steps",
              balance.work - balance.stored - balance.released,
              0.,
              1e-6,
              balance.released);
    }
  // The elastic range is a hundredth of the strain, the overstress less.
  if (law == granular)
    compare("  released over plastic work",
            balance.released / balance.plastic,
            1.,
            .03);
}

int
main()
{
  test_elastic<2>(elastic, 1e-5);
  test_elastic<3>(granular, 1e-6);
  test_flow<2>(granular, {"Perzyna exponent=1"});
  test_flow<3>(granular, {"Perzyna exponent=1"});
  test_flow<3>(granular, {"Perzyna exponent=2"});
  const std::string cohesive = "Drucker-Prager cohesive";
  test_flow<2>(cohesive, {"Cohesion=1e4", "Dilatancy angle=0.1"});
  test_flow<3>(cohesive, {"Flow=rate-independent", "Dilatancy angle=0.1"});
  test_flow<2>("Mohr-Coulomb", {"Cohesion=1e4", "Dilatancy angle=0.1"});
  test_flow<3>("Mohr-Coulomb", {"Flow=rate-independent"});
  test_flow<3>("mu(I)", {"Grain diameter=0.01"});
}
