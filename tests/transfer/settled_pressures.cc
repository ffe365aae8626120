// What the pressures of an initial equilibrium have beyond smooth ones (T29a):
// as long as the points stay, smooth pressures come back as those of the
// points; it fades with their way, is half after a quarter of a cell and gone
// after a half; points without pressure keep nothing, and no sum is negative.

#include <deal.II/base/mpi.h>

#include "scattered_points.h"

#include <mpm_granular/transfer/settled_pressures.h>

#include <iostream>

using namespace Test;

template <int dim>
void
test(const Mesh::MeshSource<dim> &source)
{
  const auto at_rest = [](const Point<dim> &) { return Tensor<1, dim>(); };
  ScatteredPoints<dim>                  test(source,
                            at_rest,
                            MPI_COMM_SELF,
                            {"of a law", "kept"});
  auto                                 &points = test.points.arrays();
  const Transfer::SettledPressures<dim> settled(test.mesh, 1, true);

  // A tenth of the points without contact; "smooth" is what a test likes.
  const auto pressure = [&](const unsigned int p) {
    return points.id[p] % 10 == 0 ? 0. : 2. + scattered(points.id[p]);
  };
  const double smooth = 2.;
  for (unsigned int p = 0; p < points.size(); ++p)
    for (unsigned int s = 0; s < n_stress<dim>; ++s)
      points.stress[s][p] = s < 3 ? -pressure(p) : 0.;

  typename Transfer::PointBlock<dim>::Array field;
  test.for_each_block([&] {
    field.fill(smooth);
    settled.keep(points, test.block, field);
  });

  // The largest difference of what comes back from smooth + part * kept, after
  // so much time.
  const auto error =
    [&](const double base, const double part, const double time) {
      double result = 0.;
      test.for_each_block([&] {
        field.fill(base);
        settled.add(points, test.block, time, field);
        for (unsigned int p = test.block.begin; p < test.block.end; ++p)
          {
            const double kept = pressure(p) > 0. ? pressure(p) - smooth : 0.;
            result            = std::max(result,
                              std::abs(field[p - test.block.begin] -
                                       std::max(0., base + part * kept)));
          }
      });
      return result;
    };
  std::cout << dim << "D: at rest " << (error(smooth, 1., 1e3) < 1e-14)
            << ", never negative " << (error(0., 1., 1e3) < 1e-14);

  // At the speed of a quarter of the own cell in a second.
  for (unsigned int p = 0; p < points.size(); ++p)
    points.velocity[dim - 1][p] =
      -.25 * test.mesh.size_of_cell(test.mesh.cell_volume(points.cell[p]));
  std::cout << ", after a quarter of a cell " << (error(smooth, .5, 1.) < 1e-14)
            << ", another quarter of a second "
            << (error(smooth, .5 * .875, .25) < 1e-14) << ", half a cell "
            << (error(smooth, 0., 2.) < 1e-14) << std::endl;
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
