// The return equation x + A x^N = x_tr (T20) over the range of pressures,
// exponents, fluidities and steps that occur, against the equation itself, and
// its limits.

#include <mpm_granular/materials/return_mapping.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <string>

using namespace mpm_granular::Materials;

constexpr double shear_modulus = 1e6 / 2.6; // Pa
constexpr double slope         = 36. / 35.;

/// 3 G gamma dt [Pa].
double
flow(const double fluidity, const double time_step)
{
  return 3. * shear_modulus * fluidity * time_step;
}

/// q / (m p) after a step of @p time_step from q_tr = ratio m p.
double
relative_stress(const double exponent,
                const double ratio,
                const double pressure,
                const double fluidity,
                const double time_step)
{
  const double yield = slope * pressure;
  return return_factor(
           ratio * yield, yield, flow(fluidity, time_step), exponent, 0.) *
         ratio;
}

void
verdict(const std::string &what, const bool good, const double value)
{
  std::cout << what << ": " << (good ? "yes" : "no, " + std::to_string(value))
            << std::endl;
}

class Random
{
public:
  /// Between two values, uniform in the logarithm.
  double
  between(const double lower, const double upper)
  {
    const double fraction = generator() / 4294967296.;
    return lower * std::pow(upper / lower, fraction);
  }

private:
  std::mt19937 generator{42};
};

/// Largest residuals and numbers of iterations over random sets.
void
test_random_sets()
{
  Random       random;
  double       worst_residual = 0., worst_closed_form = 0.;
  unsigned int most_iterations = 0;
  bool         in_range = true, increasing = true;
  for (unsigned int i = 0; i < 200000; ++i)
    {
      const double N     = random.between(0.1, 31.);
      const double yield = slope * random.between(1e-3, 1e6);
      const double viscous =
        flow(random.between(1e-3, 1e8), random.between(1e-8, 1.));
      const double x_tr = random.between(1e-6, 1e6);
      const double A    = viscous / yield;

      const Overstress result = overstress_after_step(x_tr, A, N);
      const double     x      = result.value;
      const double residual   = std::abs(x + A * std::pow(x, N) - x_tr) / x_tr;
      worst_residual          = std::max(worst_residual, residual);
      most_iterations         = std::max(most_iterations, result.n_iterations);
      in_range                = in_range && x > 0. && x <= x_tr * (1. + 1e-15);
      increasing =
        increasing && overstress_after_step(1.001 * x_tr, A, N).value > x;

      const double q_tr   = yield * (1. + x_tr);
      const double closed = linear_return_factor(q_tr, yield, viscous);
      const double newton = return_factor(q_tr, yield, viscous, 1., 0.);
      worst_closed_form =
        std::max(worst_closed_form, std::abs(newton / closed - 1.));
    }
  // Round-off, which x^N magnifies by N and x = y^(1/N) by 1/N.
  verdict("Residual below 2e-14 of x_tr",
          worst_residual < 2e-14,
          worst_residual * 1e15);
  verdict("At most 8 iterations", most_iterations <= 8, most_iterations);
  verdict("0 < x <= x_tr", in_range, 0.);
  verdict("x increases with x_tr", increasing, 0.);
  verdict("N = 1: closed form and Newton agree to 1e-14",
          worst_closed_form < 1e-14,
          worst_closed_form * 1e15);
}

/// Exponents with an equation of their own that is solved by hand.
void
test_known_roots()
{
  const auto compare =
    [](const std::string &what, const double value, const double expected) {
      verdict(what, std::abs(value / expected - 1.) < 1e-14, value);
    };
  const double A = 7., c = 3.;
  compare("N = 1: x = c/(1 + A)",
          overstress_after_step(c, A, 1.).value,
          c / (1. + A));
  compare("N = 2: quadratic equation",
          overstress_after_step(c, A, 2.).value,
          (-1. + std::sqrt(1. + 4. * A * c)) / (2. * A));
  compare("N = 1/2: quadratic equation",
          overstress_after_step(c, A, .5).value,
          std::pow((-A + std::sqrt(A * A + 4. * c)) / 2., 2));
  // 1 + A = c is solved by x = 1 for any exponent.
  for (const double N : {0.07, 0.3, 1.5, 3., 4., 17.3, 64., 100.})
    compare("N = " + std::to_string(N).substr(0, 6) + ": x = 1",
            overstress_after_step(1. + A, A, N).value,
            1.);
}

void
test_limits()
{
  const double p = 1e4;
  for (const double N : {0.3, 1., 2., 7.})
    {
      verdict("gamma to infinity: q = m p",
              std::abs(relative_stress(N, 3., p, 1e40, 1e-4) - 1.) < 1e-3,
              relative_stress(N, 3., p, 1e40, 1e-4));
      verdict("gamma dt to 0: q = q_tr",
              std::abs(relative_stress(N, 3., p, 1e-12, 1e-4) - 3.) < 1e-6,
              relative_stress(N, 3., p, 1e-12, 1e-4));
      verdict("p to 0: q to 0",
              return_factor(1e4, 1e-7, flow(50., 1e-2), N, 0.) < 1e-6,
              return_factor(1e4, 1e-7, flow(50., 1e-2), N, 0.));
      // Even and fractional exponents alike: the switch is on q > m p.
      verdict("inside the cone: elastic",
              relative_stress(N, 0.2, p, 50., 1e-3) == 0.2 &&
                relative_stress(N, 1., p, 50., 1e-3) == 1.,
              relative_stress(N, 0.2, p, 50., 1e-3));
    }

  // N to infinity is not the rate-independent limit but q = 2 m p: x^N
  // vanishes for x < 1. Values of an independent script, q_tr = 3 m p.
  std::cout << "N = 10, 100, 1000: q/(m p) =";
  for (const double N : {10., 100., 1000.})
    std::cout << ' '
              << std::round(relative_stress(N, 3., 1e4, 50., 5e-5) * 1e3) / 1e3;
  std::cout << std::endl;

  // N to 0: the rate is gamma as soon as q > m p.
  const double q = 3. * slope * p - flow(50., 5e-5);
  verdict("N to 0: q = q_tr - 3 G gamma dt",
          std::abs(relative_stress(1e-3, 3., p, 50., 5e-5) * slope * p / q -
                   1.) < 1e-3,
          relative_stress(1e-3, 3., p, 50., 5e-5) * slope * p / q);

  // The closed form at the ends of its range.
  verdict("N = 1, no stress at all: factor 1 or 0, a number",
          linear_return_factor(0., 1., 1.) == 1. &&
            linear_return_factor(0., 0., 1.) == 0.,
          linear_return_factor(0., 0., 1.));
  verdict("N = 1, no pressure: no stress",
          linear_return_factor(1e3, 0., 1.) == 0.,
          linear_return_factor(1e3, 0., 1.));
  verdict("Where m p is negligible: no stress",
          return_factor(1e3, 1e-8, 1., 2., 1e-6) == 0.,
          return_factor(1e3, 1e-8, 1., 2., 1e-6));
  verdict("What is not a number stays so",
          std::isnan(linear_return_factor(std::nan(""), 1., 1.)) &&
            std::isnan(linear_return_factor(1., std::nan(""), 1.)) &&
            std::isnan(return_factor(std::nan(""), 1., 1., 2., 0.)) &&
            std::isnan(return_factor(1., std::nan(""), 1., 2., 0.)),
          0.);
}

int
main()
{
  test_random_sets();
  test_known_roots();
  test_limits();
}
