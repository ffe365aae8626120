// mu(I): one step of backward Euler against bisection on the definition,
// tau = mu(I) p with the rate (tau_tr - tau)/(G dt) (T58b), over pressures and
// steps; simple shear goes to tau = mu(I) p; separation as of the other laws.

#include "single_point.h"

#include <algorithm>

using namespace Test;

const std::string mu_of_i = "mu(I)";

constexpr double mu_s = .38, mu_2 = .64, I_0 = .279, diameter = 1e-3,
                 density = 2500., G = 1e6 / 2.6, K = 1e6 / 1.2;

double
friction(const double rate, const double p)
{
  const double I = rate * diameter * std::sqrt(density / p);
  return mu_s + (mu_2 - mu_s) * I / (I_0 + I);
}

/// Largest error relative to p.
void
test_step(const std::string &text)
{
  const double time_step = std::stod(text);
  double       worst     = 0.;
  for (const double p : {1e-3, 1., 1e3, 1e5})
    for (const double ratio : {.1, .37, .3801, .5, .64, .7, 2., 30.})
      {
        const double   tau_tr = ratio * p;
        SinglePoint<2> point(mu_of_i, {}, pressure_and_shear<2>(p, tau_tr));
        point.step(Tensor<2, 2>(), time_step);
        double lower = std::min(tau_tr, mu_s * p),
               upper = std::min(tau_tr, mu_2 * p);
        for (unsigned int k = 0; k < 200; ++k)
          {
            const double middle = .5 * (lower + upper);
            const double rate   = (tau_tr - middle) / (G * time_step);
            (middle > friction(rate, p) * p ? upper : lower) = middle;
          }
        worst = std::max(worst, std::abs(point.stress()[3] - lower) / p);
      }
  compare("a step of " + text + " s, tau/p", worst, 0., 1e-12, 1.);
}

template <int dim>
void
test_shear(const double rate)
{
  const double     p = 1e3;
  SinglePoint<dim> point(mu_of_i,
                         {"Young modulus=1e9"},
                         pressure_and_shear<dim>(p, 0.));
  for (unsigned int n = 0; n < 400; ++n)
    point.step(simple_shear<dim>(rate), 1e-5 / rate);
  compare("tau/p at " + std::to_string(rate) + " 1/s",
          point.equivalent_stress() / std::sqrt(3.) / p,
          friction(rate, p),
          1e-9);
}

void
test_separation()
{
  SinglePoint<3> point(mu_of_i, {}, pressure_and_shear<3>(1e3, 1e2));
  Tensor<2, 3>   opening;
  opening[2][2] = std::expm1(.01 + 1e3 / K);
  point.step(opening, 1.);
  compare(
    "open, stress", point.equivalent_stress() + point.pressure(), 0., 0., 1.);
  compare("  gap", point.history(1), .01, 1e-12);
  Tensor<2, 3> closing;
  closing[2][2] = std::expm1(-.01 - 2e3 / K);
  point.step(closing, 1.);
  compare("  closed, p in kPa", point.pressure() / 1e3, 2., 1e-11);
}

int
main()
{
  for (const std::string time_step : {"1e-7", "1e-4", "1"})
    test_step(time_step);
  test_shear<2>(.1);
  test_shear<3>(100.);
  test_shear<2>(3000.);
  test_separation();
}
