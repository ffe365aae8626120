// Oedometer at the axial rate a from a state on the cone, N = 1:
// p = p_0 + K a t, q = (1 + x) m p, x = x* + (x_0 - x*) (p/p_0)^-e with
// x* = (2G - m K) a/(3 G gamma + m K a), e = (3 G gamma + m K a)/(m K a)
// (from T4, T6). E = 1e6 Pa, nu = 0.2, gamma = 1/s, a = 1/s, p_0 = 1 kPa:
// x* = 0.143791, e = 3.1875, at t = 0.02 s p = 12111.11 Pa, q = 14247.734 Pa.
// (At nu = 0.3 and 30 degrees an oedometer stays elastic.)

#include "single_point.h"

using namespace Test;

constexpr double K = 1e6 / 1.8, G = 1e6 / 2.4, slope = 36. / 35., rate = 1.,
                 gamma_rate = 1., p_0 = 1e3, end = 0.02;

template <int dim>
void
test(const unsigned int axis)
{
  std::cout << dim << "D, axis " << axis << std::endl;
  const double denominator = 3. * G * gamma_rate + slope * K * rate;
  const double x_star      = (2. * G - slope * K) * rate / denominator;
  const double p           = p_0 + K * rate * end;
  const double x =
    x_star * (1. - std::pow(p / p_0, -denominator / (slope * K * rate)));
  const double q = (1. + x) * slope * p;
  compare("  x*", x_star, 0.143791, 1e-5);
  compare("  p, kPa", p / 1e3, 12.11111, 1e-6);
  compare("  q, kPa", q / 1e3, 14.247734, 1e-7);

  std::vector<double> errors;
  for (const unsigned int n_steps : {20, 40, 80, 160})
    {
      Stress<dim> initial{};
      for (unsigned int c = 0; c < 3; ++c)
        initial[c] = -p_0 + (c == axis ? -2. : 1.) / 3. * slope * p_0;
      SinglePoint<dim> point(granular,
                             {"Poisson ratio=0.2", "Fluidity=1"},
                             initial);
      // Each step multiplies the height by exp(-a dt), so that the logarithm of
      // the volume falls as in the formula. The deviator's strain is then
      // smaller by a dt/2, an error of first order as that of backward Euler.
      const double   time_step = end / n_steps;
      Tensor<2, dim> gradient;
      gradient[axis][axis] = std::expm1(-rate * time_step) / time_step;
      for (unsigned int n = 0; n < n_steps; ++n)
        point.step(gradient, time_step);
      errors.push_back(point.equivalent_stress() / q - 1.);
      if (n_steps == 160)
        {
          compare("  p of the code", point.pressure() / p, 1., 1e-12);
          compare("  volume", point.volume(), std::exp(-rate * end), 1e-12);
          compare("  q of the code", point.equivalent_stress() / q, 1., 5e-5);
        }
    }
  compare_order("  convergence", errors, 1., .05);
}

int
main()
{
  test<2>(0);
  test<2>(1);
  test<3>(0);
  test<3>(2);
}
