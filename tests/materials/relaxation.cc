// Relaxation at fixed strain, N = 1: q = m p + (q_0 - m p) exp(-t/tau) with
// tau = m p/(3 G gamma) (from T6), to which backward Euler converges with order
// 1; the released energy is the loss of V q^2/(6 G) (T28).

#include "single_point.h"

using namespace Test;

constexpr double G = 1e6 / 2.6, slope = 36. / 35., p = 1e4;

template <int dim>
void
test(const Stress<dim> &direction)
{
  const double yield = slope * p, tau = yield / (3. * G * 50.),
               q_0 = 2. * yield;
  std::vector<double> errors;
  double              released = 0., strain = 0.;
  for (const unsigned int n_steps : {10, 20, 40, 80})
    {
      Stress<dim> initial = pressure_and_shear<dim>(p, 0.);
      for (unsigned int c = 0; c < n_stress<dim>; ++c)
        initial[c] += q_0 * direction[c];
      SinglePoint<dim> point(granular, {}, initial);
      released = 0.;
      for (unsigned int n = 0; n < n_steps; ++n)
        released += point.step(Tensor<2, dim>(), 2. * tau / n_steps);
      strain             = point.history(0);
      const double q     = point.equivalent_stress();
      const double exact = yield + (q_0 - yield) * std::exp(-2.);
      errors.push_back(q / exact - 1.);

      if (n_steps == 80)
        {
          compare("  s keeps its direction",
                  (point.stress()[0] + p) / q,
                  direction[0],
                  1e-13,
                  1.);
          compare("  released energy",
                  released / 100.,
                  (q_0 * q_0 - q * q) / (6. * G) / 100.,
                  1e-12);
          compare("  viscoplastic strain", strain, (q_0 - q) / (3. * G), 1e-12);
          compare("  ln J_s", point.history(1), -p * 3. * .4 / 1e6, 1e-14);
        }
    }
  // Of an independent script: 2.3e-2, 1.2e-2, 5.9e-3, 3.0e-3.
  const double expected[] = {2.3e-2, 1.2e-2, 5.9e-3, 3.0e-3};
  for (unsigned int i = 0; i < errors.size(); ++i)
    compare("  error, 1e-3", errors[i] * 1e3, expected[i] * 1e3, .03);
  compare_order("  convergence", errors, 1., .03);
}

int
main()
{
  // Unit directions: q = 1.
  std::cout << "2D, shear" << std::endl;
  test<2>({{0., 0., 0., 1. / std::sqrt(3.)}});
  std::cout << "2D, compression out of the plane" << std::endl;
  test<2>({{1. / 3., 1. / 3., -2. / 3., 0.}});
  std::cout << "3D, shear" << std::endl;
  test<3>({{0., 0., 0., 0., 0., 1. / std::sqrt(3.)}});
  std::cout << "3D, mixed" << std::endl;
  // q^2 = 3/2 (2 * .25) + 3 * (1/12) = 1.
  test<3>({{.5, -.5, 0., 0., 1. / std::sqrt(12.), 0.}});
}
