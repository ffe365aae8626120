// The cone with cohesion, dilatancy and a cap on tension.
//
// - Without them it is the law of the shipped walls, over random paths with
//   separation, for every rule of separation.
// - The return of random trial stresses, one step without strain: a solution of
//   the equations (T51) and (T53a) by bisection in a different unknown, the
//   overstress. Nothing creates energy.
// - Fluidity: the distance to the rate-independent stress is of the order one.

#include "single_point.h"

#include <random>

using namespace Test;

const std::string cohesive = "Drucker-Prager cohesive";

std::mt19937 generator(11);

double
random_number()
{
  return generator() / 2147483648. - 1.;
}

template <int dim>
void
test_default(const std::vector<std::string> &entries)
{
  SinglePoint<dim> fast(granular, entries, pressure_and_shear<dim>(1e3, 3e2));
  SinglePoint<dim> general(cohesive,
                           entries,
                           pressure_and_shear<dim>(1e3, 3e2));
  double           of_stress = 0., of_energy = 0., of_gap = 0., released = 0.;
  unsigned int     n_open = 0;
  for (unsigned int n = 0; n < 3000; ++n)
    {
      Tensor<2, dim> gradient;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          gradient[i][j] = 20. * random_number();
      const double one   = fast.step(gradient, 1e-4);
      const double other = general.step(gradient, 1e-4);
      released += one;
      of_energy = std::max(of_energy, std::abs(one - other));
      of_gap =
        std::max(of_gap,
                 std::abs(std::max(fast.history(1), 0.) - general.history(1)));
      n_open += fast.pressure() == 0.;
      for (unsigned int c = 0; c < n_stress<dim>; ++c)
        of_stress =
          std::max(of_stress, std::abs(fast.stress()[c] - general.stress()[c]));
    }
  std::cout << dim << "D" << (entries.empty() ? "" : ", " + entries.back())
            << ": opens " << (n_open > 20 && n_open < 2980 ? "at times" : "?")
            << std::endl;
  compare("  stress", of_stress / 1e4, 0., 1e-11, 1.);
  compare("  gap", of_gap, 0., 1e-13, 1.);
  compare("  released energy", of_energy, 0., 1e-11, released);
  compare(
    "  viscoplastic strain", general.history(0), fast.history(0), 1e-11, 1.);
}

struct Case
{
  double      phi, cohesion, psi, tension, N;
  std::string fluidity; ///< empty: rate-independent
};

/// m = 6 S/(3 - S).
double
slope(const double degrees)
{
  const double sine = std::sin(degrees * numbers::PI / 180.);
  return 6. * sine / (3. - sine);
}

void
test_return(const Case &test)
{
  const double K = 1e7 / 1.2, G = 1e7 / 2.6;
  const double m = slope(test.phi), beta = slope(test.psi);
  const double apex = test.cohesion / std::tan(test.phi * numbers::PI / 180.);
  std::vector<std::string> entries = {
    "Young modulus=1e7",
    "Poisson ratio=0.3",
    "Cone slope=triaxial compression",
    "Friction angle=" + std::to_string(test.phi),
    "Cohesion=" + std::to_string(test.cohesion),
    "Dilatancy angle=" + std::to_string(test.psi),
    "Tensile strength=" + std::to_string(test.tension)};
  if (test.fluidity.empty())
    entries.push_back("Flow=rate-independent");
  else
    {
      entries.push_back("Fluidity=" + test.fluidity);
      entries.push_back("Perzyna exponent=" + std::to_string(test.N));
    }
  const double amount =
    test.fluidity.empty() ? 0. : std::stod(test.fluidity) * 1e-3;

  SinglePoint<3> point(cohesive, entries, {});
  double         worst = 0., least_release = 0., of_gap = 0., of_direction = 0.;
  unsigned int   n_cone = 0, n_cap = 0, n_elastic = 0;
  for (unsigned int n = 0; n < 4000; ++n)
    {
      Stress<3> trial;
      for (double &component : trial)
        component = 2e4 * random_number();
      const double shift = -7e3 + 2e4 * random_number();
      for (unsigned int c = 0; c < 3; ++c)
        trial[c] += shift;
      point.set_stress(trial);
      const double p_tr = point.pressure(), q_tr = point.equivalent_stress();
      const double released = point.step(Tensor<2, 3>(), 1e-3);
      least_release         = std::min(least_release, released);

      // The overstress x that the flow of (T53a) leaves, by bisection: with
      // strength (1 + x), the rate-independent multiplier is l(x).
      double     q = q_tr, p = p_tr, opening = 0.;
      const auto multiplier = [&](const double x) {
        const double factor = m * (1. + x);
        double       lambda =
          (q_tr - factor * (p_tr + apex)) / (3. * G + factor * K * beta);
        if (lambda < 0.)
          lambda = 0.;
        if (p_tr + K * beta * lambda < -test.tension)
          lambda =
            std::max(0., (q_tr - factor * (apex - test.tension)) / (3. * G));
        return lambda;
      };
      double lower = 0., upper = 1.;
      if (amount > 0.)
        {
          const auto is_high = [&](const double x) {
            return amount * std::pow(x, test.N) > multiplier(x);
          };
          while (!is_high(upper))
            upper *= 2.;
          for (unsigned int k = 0; k < 200; ++k)
            (is_high(.5 * (lower + upper)) ? upper : lower) =
              .5 * (lower + upper);
        }
      const double lambda = multiplier(lower);
      q -= 3. * G * lambda;
      p += K * beta * lambda;
      if (p < -test.tension)
        {
          opening = (-test.tension - p) / K;
          p       = -test.tension;
        }
      (lambda == 0. && opening == 0. ? n_elastic :
       opening > 0.                  ? n_cap :
                                       n_cone)++;
      worst            = std::max({worst,
                                   std::abs(point.pressure() - p),
                                   std::abs(point.equivalent_stress() - q)});
      of_gap           = std::max(of_gap, std::abs(point.history(1) - opening));
      const auto after = point.stress();
      for (unsigned int c = 3; c < 6; ++c)
        of_direction =
          std::max(of_direction,
                   std::abs(after[c] -
                            trial[c] * point.equivalent_stress() / q_tr));
    }
  std::cout << "phi " << test.phi << ", c " << test.cohesion << ", psi "
            << test.psi << ", T " << test.tension << ", "
            << (test.fluidity.empty() ? "rate-independent" :
                                        entries[7] + ", " + entries[8])
            << ": each case "
            << (std::min({n_cone, n_cap, n_elastic}) > 5 ? "occurs" : "?")
            << std::endl;
  compare("  stress, of 10 kPa", worst / 1e4, 0., 1e-9, 1.);
  compare("  direction", of_direction / 1e4, 0., 1e-11, 1.);
  compare("  gap", of_gap, 0., 1e-11, 1.);
  compare("  energy created", least_release, 0., 1e-9, 1.);
}

void
test_limit()
{
  const auto q = [&](const std::string &flow) {
    SinglePoint<2> point(cohesive,
                         {"Cohesion=1e3", "Dilatancy angle=10", flow},
                         pressure_and_shear<2>(1e4, 1.5e4));
    point.step(Tensor<2, 2>(), 1e-3);
    return point.equivalent_stress();
  };
  const double        limit = q("Flow=rate-independent");
  std::vector<double> errors;
  for (const std::string gamma : {"1e4", "2e4", "4e4"})
    errors.push_back(q("Fluidity=" + gamma) - limit);
  compare_order("1/gamma", errors, 1., .02);
}

/// After an opening, the gap closes before there is pressure; tension goes
/// first.
void
test_gap()
{
  SinglePoint<3> point(cohesive,
                       {"Cohesion=1e3", "Tensile strength=500"},
                       {{-1e3, -1e3, -1e3}});
  const double   K    = 1e6 / 1.2;
  const auto     move = [&](const double log_volume) {
    Tensor<2, 3> gradient;
    for (unsigned int d = 0; d < 3; ++d)
      gradient[d][d] = std::expm1(log_volume / 3.);
    return point.step(gradient, 1.);
  };
  // To the tensile strength and 0.01 beyond, which costs T 0.01.
  const double released = move(1500. / K + .01);
  compare("open: p, kPa", point.pressure() / 1e3, -.5, 1e-12);
  compare("  gap", point.history(1), .01, 1e-12);
  compare("  released", released / point.volume(), 5., 1e-12);
  move(-300. / K);
  compare("back a little: p, kPa", point.pressure() / 1e3, -.2, 1e-11);
  move(-200. / K - .004);
  compare("closing: p, kPa", point.pressure() / 1e3, 0., 1e-11, 1.);
  compare("  gap", point.history(1), .006, 1e-11);
  move(-.006 - 700. / K);
  compare("closed: p, kPa", point.pressure() / 1e3, .7, 1e-10);
  compare("  gap", point.history(1), 0., 1e-14, 1.);
}

int
main()
{
  test_default<2>({});
  test_default<3>({"Perzyna exponent=2"});
  test_default<2>({"Separation=reset"});
  test_default<3>({"Separation=capped", "Log volume ratio cap=0.003"});
  test_return({30., 0., 0., 0., 1., ""});
  test_return({35., 3e3, 20., 2e3, 1., ""});
  test_return({35., 3e3, 35., 0., 1., "5"});
  test_return({30., 2e3, 10., 3e3, 2., "5"});
  test_return({25., 2e3, 5., 1e3, .4, "20"});
  test_limit();
  test_gap();
}
