// Elastic simple shear up to unit strain k with the Jaumann rate, in closed
// form s_xy = G sin k, s_xx = -s_yy = G (1 - cos k), s_zz = 0 (physics of T3):
// the sign of the spin, the factor 2G, the second order of the midpoint rule,
// and its error in 50 and 100 steps as of the theory, 1.5e-5 G and 3.7e-6 G.

#include "single_point.h"

using namespace Test;

/// Largest error of the deviator after n steps, over G.
template <int dim>
double
error_of(const std::string &law, const unsigned int n_steps)
{
  const double rate = 2., strain = 1., pressure = 1e6;
  // Far inside the cone of the granular law, which then is elastic.
  SinglePoint<dim> point(law,
                         {"Young modulus=1e6", "Poisson ratio=0.3"},
                         pressure_and_shear<dim>(pressure, 0.));
  const double     shear_modulus = 1e6 / 2.6;
  for (unsigned int n = 0; n < n_steps; ++n)
    point.step(simple_shear<dim>(rate), strain / rate / n_steps);

  Stress<dim> expected{};
  expected[0]       = shear_modulus * (1. - std::cos(strain)) - pressure;
  expected[1]       = -shear_modulus * (1. - std::cos(strain)) - pressure;
  expected[2]       = -pressure;
  expected[3]       = shear_modulus * std::sin(strain);
  double     error  = 0.;
  const auto stress = point.stress();
  for (unsigned int c = 0; c < n_stress<dim>; ++c)
    error = std::max(error, std::abs(stress[c] - expected[c]) / shear_modulus);
  return error;
}



template <int dim>
void
test(const std::string &law)
{
  std::cout << law << ", " << dim << "D" << std::endl;
  std::vector<double> errors;
  for (const unsigned int n : {50, 100, 200})
    errors.push_back(error_of<dim>(law, n));
  compare("  error in 50 steps, 1e-5 G", errors[0] * 1e5, 1.5, .05);
  compare("  error in 100 steps, 1e-6 G", errors[1] * 1e6, 3.7, .05);
  compare_order("  convergence", errors, 2., .01);
}



int
main()
{
  for (const std::string &law : {elastic, granular})
    {
      test<2>(law);
      test<3>(law);
    }
}
