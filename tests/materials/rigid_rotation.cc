// Rotation without strain: the deviator turns with the body (T3), by the exact
// rotation to second order in the step, and its invariants stay to round-off
// for steps of any size (T18).

#include <deal.II/base/symmetric_tensor.h>

#include "single_point.h"

using namespace Test;

/// The full tensor of a deviator in 3D.
Tensor<2, 3>
full_tensor(const Stress<3> &stress)
{
  Tensor<2, 3> result;
  for (unsigned int c = 0; c < 6; ++c)
    result[stress_index[c][0]][stress_index[c][1]] =
      result[stress_index[c][1]][stress_index[c][0]] = stress[c];
  return result - trace(result) / 3. * Tensor<2, 3>(unit_symmetric_tensor<3>());
}

/// exp(W) for the spin with axis vector @p axis and angle |axis|, after
/// Rodrigues.
Tensor<2, 3>
exact_rotation(const Tensor<1, 3> &axis)
{
  const double angle = axis.norm();
  Tensor<2, 3> W;
  W[0][1] = -axis[2];
  W[1][0] = axis[2];
  W[0][2] = axis[1];
  W[2][0] = -axis[1];
  W[1][2] = -axis[0];
  W[2][1] = axis[0];
  return Tensor<2, 3>(unit_symmetric_tensor<3>()) +
         std::sin(angle) / angle * W +
         (1. - std::cos(angle)) / (angle * angle) * W * W;
}

/// The stress of 2D as one of 3D.
template <int dim>
Stress<3>
in_space(const Stress<dim> &stress)
{
  Stress<3> result{};
  for (unsigned int c = 0; c < n_stress<dim>; ++c)
    result[c] = stress[c];
  return result;
}

/// Turns a stressed point by the angle |axis| in n steps.
template <int dim>
void
test(const std::string               &law,
     const Tensor<1, 3>              &axis,
     const std::vector<unsigned int> &numbers_of_steps)
{
  Stress<dim> initial{{-9e4, -10e4, -11.5e4, 4e3}};
  if constexpr (dim == 3)
    {
      initial[4] = -7e3;
      initial[5] = 2e3;
    }
  const Tensor<2, 3> R = exact_rotation(axis);
  const Tensor<2, 3> exact =
    R * full_tensor(in_space<dim>(initial)) * transpose(R);
  std::cout << law << ", " << dim << "D, angle " << axis.norm() << std::endl;
  std::vector<double> errors;
  for (const unsigned int n_steps : numbers_of_steps)
    {
      SinglePoint<dim> point(law, {}, initial);
      Tensor<2, dim>   gradient;
      const double     swirl[3][3] = {{0., -axis[2], axis[1]},
                                      {axis[2], 0., -axis[0]},
                                      {-axis[1], axis[0], 0.}};
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          gradient[i][j] = swirl[i][j];
      const double q = point.equivalent_stress();
      const double determinant_before =
        determinant(full_tensor(in_space<dim>(initial)));
      for (unsigned int n = 0; n < n_steps; ++n)
        {
          point.step(gradient, 1. / n_steps);
          // Positions advanced along a velocity that turns move outwards, a
          // change of volume of second order; only rotation is meant here.
          if (law == granular)
            point.points.history[1][0] = -.12;
        }
      const Tensor<2, 3> deviator = full_tensor(in_space<dim>(point.stress()));
      errors.push_back((deviator - exact).norm() / exact.norm());
      const std::string steps = "  " + std::to_string(n_steps) + " steps: ";
      compare(steps + "q, kPa",
              point.equivalent_stress() / 1e3,
              q / 1e3,
              1e-12);
      compare(steps + "det(s)",
              determinant(deviator) / 1e12,
              determinant_before / 1e12,
              1e-12,
              std::pow(q / 1e4, 3));
      compare(steps + "viscoplastic strain",
              law == granular ? point.history(0) : 0.,
              0.,
              1e-15,
              1.);
    }
  if (axis.norm() < 3.)
    {
      compare(" turns with the body", errors.back(), 0., 1e-5, 1.);
      compare_order(" convergence", errors, 2., .02);
    }
}

int
main()
{
  const Tensor<1, 3> axis_z({0., 0., 1.2}), axis({.8, -.9, .6});
  for (const std::string &law : {elastic, granular})
    {
      test<2>(law, axis_z, {125, 250, 500});
      test<3>(law, axis, {125, 250, 500});
    }
  test<3>(elastic, 100. * axis, {1, 10});
}
