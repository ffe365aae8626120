// The smooth pressure of irregularly placed points: a linear field comes back
// to round-off; noise on it becomes small; points without contact take no part.

#include <deal.II/base/mpi.h>

#include "scattered_points.h"

#include <mpm_granular/transfer/pressure_filter.h>

#include <iostream>

using namespace Test;

/// Sets the pressures of all points, then returns the largest difference of the
/// smooth pressure from @p expected, over the points that pressure > 0.
template <int dim>
double
largest_error(ScatteredPoints<dim>                            &test,
              const std::function<double(const unsigned int)> &pressure,
              const std::function<double(const Point<dim> &)> &expected)
{
  auto &points = test.points.arrays();
  for (unsigned int p = 0; p < points.size(); ++p)
    for (unsigned int s = 0; s < n_stress<dim>; ++s)
      points.stress[s][p] = s < 3 ? -pressure(p) : 0.;
  test.project();

  Transfer::PressureFilter<dim> filter(test.mesh);
  filter.reinit(test.fields);
  const auto find_shape_values = [&] {
    Transfer::find_shape_values(test.mesh, points, test.block);
    Transfer::relocate(test.mesh, test.partition, points, test.block);
  };
  test.for_each_block([&] {
    find_shape_values();
    for (const auto &run : test.block.runs)
      filter.add(test.fields, points, test.block, run);
  });
  filter.find_gradients(test.fields);

  double                                    error = 0.;
  typename Transfer::PointBlock<dim>::Array smooth;
  test.for_each_block([&] {
    find_shape_values();
    filter.evaluate(test.fields, points, test.block, smooth);
    for (unsigned int p = test.block.begin; p < test.block.end; ++p)
      if (points.pressure(p) > 0.)
        error = std::max(error,
                         std::abs(smooth[p - test.block.begin] -
                                  expected(points.location(p))));
  });
  return error;
}

template <int dim>
void
test(const Mesh::MeshSource<dim> &source)
{
  ScatteredPoints<dim> test(source, [](const Point<dim> &) {
    return Tensor<1, dim>();
  });
  const auto          &points = test.points.arrays();
  const auto           linear = [](const Point<dim> &x) {
    return 3. - 2. * x[dim - 1] + x[0];
  };
  const auto at = [&](const unsigned int p) {
    return linear(points.location(p));
  };
  // Of either sign with every second point.
  const auto noise = [&](const unsigned int p) {
    return points.id[p] % 2 == 0 ? 0.5 : -0.5;
  };

  std::cout << dim << "D: linear pressure kept "
            << (largest_error<dim>(test, at, linear) < 1e-11)
            << ", noise of 0.5 becomes less than 0.25 "
            << (largest_error<dim>(
                  test,
                  [&](const unsigned int p) { return at(p) + noise(p); },
                  linear) < 0.25)
            << ", points without contact take no part "
            << (largest_error<dim>(
                  test,
                  [&](const unsigned int p) {
                    return points.id[p] % 3 == 0 ? -7. : at(p);
                  },
                  linear) < 1e-11)
            << ", never negative "
            << (largest_error<dim>(
                  test,
                  [&](const unsigned int p) { return at(p) * 1e-3; },
                  [](const Point<dim> &) { return 0.; }) < 4.1e-3)
            << std::endl;
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>(JitteredBox<2>(4));
  test<3>(JitteredBox<3>(4));
  test<2>(BoxMesh<2>("hypercubes", 8));
  test<3>(BoxMesh<3>("hypercubes", 6));
}
