// Drained triaxial compression: axial rate a at constant lateral stress. In
// the steady state flow is isochoric and q = 3 sigma_3 mu/(3 - mu) with mu =
// m (1 + (a/gamma)^(1/N)) (from T5, T6). For sigma_3 = 10 kPa, 30 degrees:
// 15652.2 Pa for a -> 0 (sigma_1/sigma_3 = 2.5652), 18165.1 Pa at a/gamma =
// 0.1, N = 1. Backward Euler has the exact steady state, except that T18 takes
// the strain of a step as dt sym(L): 1e-4 of relative error in the rate here.

#include "single_point.h"

using namespace Test;

constexpr double lateral_stress = -1e4, gamma_rate = 50.;

/// Velocity gradient with rates along the axis z and across it.
Tensor<2, 3>
gradient_with(const double axial, const double lateral)
{
  Tensor<2, 3> gradient;
  gradient[0][0] = gradient[1][1] = lateral;
  gradient[2][2]                  = axial;
  return gradient;
}

/// The steady q, the lateral rate being adjusted in every step (secant method
/// on copies of the point's state).
double
steady_q(const std::string &exponent, const double rate)
{
  SinglePoint<3> point(granular,
                       {"Perzyna exponent=" + exponent},
                       {{-1e4, -1e4, -1e4, 0., 0., 0.}});
  const double   time_step = 1e-4 / rate;
  double         lateral   = 0.5 * rate;
  const auto     excess    = [&](const double trial_rate) {
    const auto backup = point.points;
    point.step(gradient_with(-rate, trial_rate), time_step);
    const double result = point.stress()[0] - lateral_stress;
    point.points        = backup;
    return result;
  };
  for (unsigned int n = 0; n < 4000; ++n)
    {
      double other = lateral + .01 * rate, r_lateral = excess(lateral),
             r_other = excess(other);
      for (unsigned int k = 0; k < 20 && std::abs(r_lateral) > 1e-8; ++k)
        {
          const double next =
            lateral - r_lateral * (other - lateral) / (r_other - r_lateral);
          other     = lateral;
          r_other   = r_lateral;
          lateral   = next;
          r_lateral = excess(lateral);
        }
      point.step(gradient_with(-rate, lateral), time_step);
    }
  compare("  lateral stress, kPa", point.stress()[1] / 1e3, -10., 1e-8);
  compare("  lateral rate over axial", lateral / rate, .5, 1e-3);
  return point.equivalent_stress();
}

void
test(const std::string &exponent, const double relative_rate)
{
  const double slope = 36. / 35., N = std::stod(exponent);
  const double mu       = slope * (1. + std::pow(relative_rate, 1. / N));
  const double expected = 3. * -lateral_stress * mu / (3. - mu);
  std::cout << "N = " << exponent << ", a/gamma = " << relative_rate
            << std::endl;
  const double q = steady_q(exponent, relative_rate * gamma_rate);
  compare("  q, kPa", q / 1e3, expected / 1e3, 3e-5);
}

int
main()
{
  test("1", 1e-8);
  compare("  at rest in the limit, kPa", 15.6522, 30. * 36. / 69., 1e-5);
  test("1", 0.1);
  test("2", 0.1);
  test("0.5", 0.5);
}
