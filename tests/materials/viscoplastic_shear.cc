// Steady viscoplastic simple shear at a given pressure: with lambda = 3 G gamma
// Phi / q the flow balances shear and spin at
// s_xy = G k lambda/(lambda^2 + k^2), s_xx = -s_yy = G k^2/(lambda^2 + k^2),
// where k is the shear rate (from T3, T4, T6). E = 1e6 Pa, nu = 0.3, phi = 30
// degrees, gamma = 50/s, p = 1e4 Pa, k = 10/s. The numbers in comments are of
// an independent integration of the differential equation.

#include "single_point.h"

using namespace Test;

constexpr double G = 1e6 / 2.6, slope = 36. / 35., gamma_rate = 50., p = 1e4,
                 k = 10.;

/// s_xx, s_xy and q of the steady state, by bisection for lambda.
struct SteadyState
{
  explicit SteadyState(const double exponent)
  {
    double lower = 0., upper = 1e6;
    for (unsigned int i = 0; i < 200; ++i)
      {
        const double lambda = .5 * (lower + upper);
        const double square = lambda * lambda + k * k;
        normal              = G * k * k / square;
        shear               = G * k * lambda / square;
        q                   = std::sqrt(3. * (normal * normal + shear * shear));
        const double x      = std::max(q / (slope * p) - 1., 0.);
        const double excess =
          lambda - 3. * G * gamma_rate * std::pow(x, exponent) / q;
        (excess > 0. ? upper : lower) = lambda;
      }
  }

  double normal, shear, q;
};

template <int dim>
void
test(const std::string &exponent)
{
  std::cout << dim << "D, N = " << exponent << std::endl;
  SinglePoint<dim>  point(granular,
                         {"Perzyna exponent=" + exponent},
                         pressure_and_shear<dim>(p, 0.));
  const SteadyState steady(std::stod(exponent));
  // The normal stresses settle with the rate lambda, 600/s: to exp(-24) here.
  const double time_step = 2e-6;
  double       strain    = 0.;
  for (unsigned int n = 0; n < 20000; ++n)
    {
      strain = point.history(0);
      point.step(simple_shear<dim>(k), time_step);
    }
  const auto stress = point.stress();
  compare("  s_xy", stress[3] / p, steady.shear / p, 1e-4);
  compare("  s_xx", (stress[0] + p) / p, steady.normal / p, 1e-3);
  compare("  s_yy", (stress[1] + p) / p, -steady.normal / p, 1e-3);
  compare("  s_zz", (stress[2] + p) / p, 0., 1e-10, 1.);
  compare("  q", point.equivalent_stress() / p, steady.q / p, 1e-4);
  compare("  p", point.pressure() / p, 1., 1e-12);
  // Phi gamma: all of the shear is viscoplastic except for what turns s.
  const double x = steady.q / (slope * p) - 1.;
  compare("  viscoplastic rate",
          (point.history(0) - strain) / time_step / k,
          gamma_rate * std::pow(x, std::stod(exponent)) / k,
          1e-3);
}

int
main()
{
  test<2>("1"); // s_xy = 6623.1, s_xx = 114.1, q = 11473.2
  test<3>("1");
  test<3>("2"); // s_xy = 7954.5, s_xx = 164.6, q = 13780.5
  test<2>("0.5");
}
