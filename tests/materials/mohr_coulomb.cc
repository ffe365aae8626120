// The return to the pyramid of Mohr and Coulomb with tension cut-off, for
// random trial stresses and one step without strain, against its definition
// (T54): the stress is inside of all planes, coaxial with the trial, and the
// strain that flow takes is a combination with weights >= 0 of the directions
// of those planes that it is on, found by an independent search (coordinate
// descent). For psi = phi that is the condition for the nearest stress in the
// norm of energy. In Perzyna's form the planes are those of the strength times
// 1 + x, and the sum of the weights of Mohr and Coulomb's is gamma dt x^N.

#include <deal.II/base/symmetric_tensor.h>

#include "single_point.h"

#include <random>

using namespace Test;

const std::string mohr_coulomb = "Mohr-Coulomb";

constexpr double K = 1e7 / 1.2, G = 1e7 / 2.6, time_step = 1e-3;

struct Case
{
  double      phi, cohesion, psi, tension, N;
  std::string fluidity; ///< empty: rate-independent
};

SymmetricTensor<2, 3>
tensor_of(const Stress<3> &stress)
{
  SymmetricTensor<2, 3> result;
  for (unsigned int c = 0; c < 6; ++c)
    result[stress_index[c][0]][stress_index[c][1]] = stress[c];
  return result;
}

/// In descending order; accurate also where they are equal.
std::array<double, 3>
principal_values(const SymmetricTensor<2, 3> &tensor)
{
  const auto pairs =
    eigenvectors(tensor, SymmetricTensorEigenvectorMethod::ql_implicit_shifts);
  return {{pairs[0].first, pairs[1].first, pairs[2].first}};
}

/// Weights >= 0 of @p directions that come nearest to @p target.
std::vector<double>
weights_of(const std::vector<Tensor<1, 3>> &directions,
           const Tensor<1, 3>              &target)
{
  std::vector<double> weights(directions.size(), 0.);
  Tensor<1, 3>        rest = target;
  for (unsigned int sweep = 0; sweep < 20000; ++sweep)
    {
      double change = 0.;
      for (unsigned int k = 0; k < directions.size(); ++k)
        {
          const double next =
            std::max(0.,
                     weights[k] +
                       rest * directions[k] / directions[k].norm_square());
          rest -= (next - weights[k]) * directions[k];
          change     = std::max(change, std::abs(next - weights[k]));
          weights[k] = next;
        }
      if (change < 1e-14 * target.norm())
        break;
    }
  return weights;
}

std::vector<std::string>
entries_of(const Case &test)
{
  std::vector<std::string> entries = {
    "Young modulus=1e7",
    "Poisson ratio=0.3",
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
  return entries;
}

void
test_return(const Case &test)
{
  std::mt19937 generator(17);
  const auto   random  = [&] { return generator() / 2147483648. - 1.; };
  const auto   entries = entries_of(test);
  const double degree  = numbers::PI / 180.;
  const double s       = std::sin(test.phi * degree),
               s_psi   = std::sin(test.psi * degree),
               term    = 2. * test.cohesion * std::cos(test.phi * degree);

  SinglePoint<3> point(mohr_coulomb, entries, {});
  double         outside = 0., not_coaxial = 0., residual = 0., of_rate = 0.,
         least_release   = 0.;
  unsigned int n_elastic = 0, n_of_planes[4] = {}, n_tension = 0;
  for (unsigned int n = 0; n < 4000; ++n)
    {
      Stress<3> trial;
      for (double &component : trial)
        component = 2e4 * random();
      const double shift = -1e4 + 2e4 * random();
      for (unsigned int c = 0; c < 3; ++c)
        trial[c] += shift;
      point.set_stress(trial);
      least_release =
        std::min(least_release, point.step(Tensor<2, 3>(), time_step));

      const auto before = tensor_of(trial), after = tensor_of(point.stress());
      const Tensor<2, 3> one   = before * Tensor<2, 3>(after),
                         other = after * Tensor<2, 3>(before);
      not_coaxial           = std::max(not_coaxial, (one - other).norm() / 1e8);
      const auto old_values = principal_values(before),
                 values     = principal_values(after);

      // Strain that flowed, principal values.
      Tensor<1, 3> flowed;
      double       sum = 0.;
      for (unsigned int i = 0; i < 3; ++i)
        sum += old_values[i] - values[i];
      for (unsigned int i = 0; i < 3; ++i)
        flowed[i] =
          (old_values[i] - values[i] - sum / 3.) / (2. * G) + sum / (9. * K);

      // The overstress, where flow is viscous.
      double x = 0.;
      if (!test.fluidity.empty())
        {
          const double strength = term - (values[0] + values[2]) * s;
          x                     = strength > 1e-6 ?
                                    std::max(0., (values[0] - values[2]) / strength - 1.) :
                                    0.;
        }
      const double              tolerance = 1e-5; // Pa, of 10 kPa
      std::vector<Tensor<1, 3>> directions;
      unsigned int              n_shear = 0;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          if (i != j)
            {
              const double f = (values[i] - values[j]) -
                               (1. + x) * (term - (values[i] + values[j]) * s);
              outside = std::max(outside, f / 1e4);
              if (f > -tolerance)
                {
                  Tensor<1, 3> direction;
                  direction[i] = 1. + s_psi;
                  direction[j] = s_psi - 1.;
                  directions.push_back(direction);
                  ++n_shear;
                }
            }
      bool has_tension = false;
      for (unsigned int i = 0; i < 3; ++i)
        {
          outside = std::max(outside, (values[i] - test.tension) / 1e4);
          if (values[i] > test.tension - tolerance)
            {
              directions.push_back(Point<3>::unit_vector(i));
              has_tension = true;
            }
        }
      if (flowed.norm() < 1e-13)
        {
          ++n_elastic;
          continue;
        }
      has_tension ? ++n_tension :
                    ++n_of_planes[std::min<unsigned int>(n_shear, 3)];

      const auto weights = weights_of(directions, flowed);
      double     shear   = 0.;
      for (unsigned int k = 0; k < directions.size(); ++k)
        {
          flowed -= weights[k] * directions[k];
          shear += k < n_shear ? weights[k] : 0.;
        }
      residual = std::max(residual, flowed.norm() * G / 1e4);
      // Away from corners of tension the weights are unique.
      if (!test.fluidity.empty() && !has_tension)
        of_rate = std::max(of_rate,
                           std::abs(shear - std::stod(test.fluidity) *
                                              time_step * std::pow(x, test.N)) *
                             G / 1e4);
    }
  std::cout << "phi " << test.phi << ", c " << test.cohesion << ", psi "
            << test.psi << ", T " << test.tension << ", "
            << (test.fluidity.empty() ? "rate-independent" :
                                        entries[6] + ", " + entries[7])
            << ": planes, edges, tension, elastic "
            << (n_of_planes[1] > 20 && n_of_planes[2] > 5 && n_tension > 20 &&
                    n_elastic > 20 ?
                  "occur" :
                  "?")
            << std::endl;
  compare("  outside", outside, 0., 1e-10, 1.);
  compare("  not coaxial", not_coaxial, 0., 1e-10, 1.);
  compare("  not along the planes' directions", residual, 0., 1e-6, 1.);
  if (!test.fluidity.empty())
    compare("  rate", of_rate, 0., 1e-6, 1.);
  compare("  energy created", least_release, 0., 1e-9, 1.);
}

/// The distance to the rate-independent stress, on a plane, on both edges and
/// with tension.
void
test_limit(const std::string &what, const Stress<3> &trial)
{
  const Case base{35., 2e3, 10., 1e3, 1., ""};
  const auto stress = [&](const std::string &fluidity) {
    Case test     = base;
    test.fluidity = fluidity;
    SinglePoint<3> point(mohr_coulomb, entries_of(test), trial);
    point.step(Tensor<2, 3>(), time_step);
    return tensor_of(point.stress());
  };
  const auto          limit = stress("");
  std::vector<double> errors;
  for (const std::string gamma : {"1e4", "2e4", "4e4"})
    errors.push_back((stress(gamma) - limit).norm());
  compare_order("1/gamma, " + what, errors, 1., .02);
}

int
main()
{
  test_return({30., 0., 0., 0., 1., ""});
  test_return({30., 0., 15., 0., 1., ""});
  test_return({30., 0., 15., 0., 1., "5"});
  test_return({35., 3e3, 10., 1e3, 1., ""});
  test_return({30., 2e3, 30., 2e3, 1., ""});
  test_return({35., 3e3, 10., 1e3, 1., "5"});
  test_return({30., 2e3, 0., 0., 2., "5"});
  test_return({30., 2e3, 15., 2e3, .5, "20"});
  test_limit("plane", {{-5e3, -2e4, -6e4, 0., 0., 0.}});
  test_limit("edge of compression", {{-5e3, -5e3, -6e4, 0., 0., 0.}});
  test_limit("edge of extension", {{0., -5e4, -5e4, 0., 0., 0.}});
  test_limit("tension", {{1e4, 3e3, -4e4, 0., 0., 0.}});
}
