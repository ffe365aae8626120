// What a step does to a run of points, against the definitions: the rotation
// by Cayley's form with matrices of deal.II (T18), the volume (T17) and its
// logarithm (T19) in extended precision, for steps tiny and huge.

#include <mpm_granular/materials/strain_increments.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <random>
#include <string>

using namespace dealii;
using namespace mpm_granular;
using Materials::StrainIncrements;

std::mt19937 generator(1);

double
random_number()
{
  return 2. * (generator() / 4294967296.) - 1.;
}

/// det(I + A) - 1 and its logarithm, with 64 bits of mantissa.
template <int dim>
std::pair<long double, long double>
volume_change(const Tensor<2, dim> &A)
{
  long double F[3][3] = {};
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = 0; j < dim; ++j)
      F[i][j] = A[i][j];
  const long double trace  = F[0][0] + F[1][1] + F[2][2];
  long double       minors = 0., determinant = 0.;
  for (unsigned int i = 0; i < 3; ++i)
    {
      const unsigned int j = (i + 1) % 3, k = (i + 2) % 3;
      minors += F[i][i] * F[j][j] - F[i][j] * F[j][i];
      determinant += F[0][i] * (F[1][j] * F[2][k] - F[1][k] * F[2][j]);
    }
  const long double change = trace + minors + determinant;
  return {change, std::log1p(change)};
}

struct Errors
{
  double rotation = 0., orthogonality = 0., strain = 0., trace = 0.,
         volume = 0., logarithm = 0.;
};

template <int dim>
void
add_errors(const StrainIncrements<dim> &increments,
           const unsigned int           r,
           const Tensor<2, dim>        &gradient,
           Errors                      &errors)
{
  const auto           A        = increments.time_step * gradient;
  const Tensor<2, dim> identity = unit_symmetric_tensor<dim>();
  const Tensor<2, dim> spin     = .5 * (A - transpose(A)); // dt W
  const Tensor<2, dim> Q =
    invert(identity - .25 * spin) * (identity + .25 * spin);

  Tensor<2, dim> R;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = 0; j < dim; ++j)
      R[i][j] = increments.rotation[i * dim + j][r];
  errors.rotation = std::max(errors.rotation, (R - Q * Q).norm());
  errors.orthogonality =
    std::max(errors.orthogonality, (R * transpose(R) - identity).norm());

  // The deviator has a zz component in 2D, too.
  const Tensor<2, dim> strain  = .5 * (A + transpose(A));
  const Tensor<2, dim> rotated = Q * strain * transpose(Q);
  const double         mean    = trace(A) / 3.;
  double               error   = 0.;
  for (unsigned int c = 0; c < n_stress<dim>; ++c)
    {
      const unsigned int i = stress_index[c][0], j = stress_index[c][1];
      const double       full = i < dim && j < dim ? rotated[i][j] : 0.;
      error                   = std::max(error,
                       std::abs(increments.deviatoric_strain[c][r] - full +
                                (i == j ? mean : 0.)));
    }
  errors.strain = std::max(errors.strain, error / A.norm());
  errors.trace  = std::max(errors.trace,
                          std::abs(increments.deviatoric_strain[0][r] +
                                   increments.deviatoric_strain[1][r] +
                                   increments.deviatoric_strain[2][r]) /
                            A.norm());

  const auto [change, logarithm] = volume_change(A);
  errors.volume =
    std::max<double>(errors.volume,
                     std::abs(increments.volume_ratio[r] - (1. + change)) /
                       std::pow(1. + A.norm(), dim));
  errors.logarithm =
    std::max<double>(errors.logarithm,
                     std::abs(increments.log_volume_ratio[r] - logarithm) /
                       A.norm());
}

/// A gradient with so little strain that no volume is inverted.
template <int dim>
Tensor<2, dim>
mostly_spin(const double size)
{
  Tensor<2, dim> gradient;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = 0; j <= i; ++j)
      if (i == j)
        gradient[i][i] = .02 * random_number();
      else
        {
          gradient[i][j] = random_number();
          gradient[j][i] = -gradient[i][j] * (1. + .1 * random_number());
        }
  return size * gradient;
}

template <int dim>
void
test(const double size)
{
  constexpr unsigned int      n = StrainIncrements<dim>::capacity;
  std::vector<Tensor<2, dim>> gradients(n);
  const double                time_step = 0.01;
  const auto increments = std::make_unique<StrainIncrements<dim>>();
  Errors     errors;
  for (unsigned int repetition = 0; repetition < 20; ++repetition)
    {
      for (auto &gradient : gradients)
        gradient = mostly_spin<dim>(size / time_step);
      increments->compute(make_array_view(gradients.cbegin(), gradients.cend()),
                          time_step);
      for (unsigned int r = 0; r < n; ++r)
        add_errors(*increments, r, gradients[r], errors);
    }

  const double tolerance = 4e-15;
  std::cout << dim << "D, dt L of size " << size << ':';
  for (const auto &[name, error] :
       {std::make_pair("rotation", errors.rotation),
        std::make_pair("orthogonality", errors.orthogonality),
        std::make_pair("strain", errors.strain),
        std::make_pair("trace", errors.trace),
        std::make_pair("volume", errors.volume),
        std::make_pair("logarithm", errors.logarithm)})
    {
      std::cout << ' ' << name;
      if (!(error < tolerance))
        std::cout << " (error " << error << ')';
    }
  std::cout << std::endl;
}

int
main()
{
  for (const double size : {1e-12, 1e-6, 1e-3, 0.02, 0.1, 1., 30.})
    {
      test<2>(size);
      test<3>(size);
    }
}
