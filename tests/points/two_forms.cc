// The working set and deal.II's handler hold the same points: nothing changes
// on the way there and back, ordering keeps every point whole, lost ones go.

#include <deal.II/base/mpi.h>

#include "../jittered_box.h"
#include "../seeds.h"

#include <mpm_granular/points/material_points.h>

#include <iostream>

using namespace Test;

/// A number that tells point @p p from others, made of all it consists of.
template <int dim>
double
fingerprint(const Points::PointArrays<dim> &points, const unsigned int p)
{
  double sum = points.mass[p] + points.volume[p] + points.material[p];
  for (unsigned int d = 0; d < dim; ++d)
    sum += 3. * points.position[d][p] + 5. * points.velocity[d][p];
  for (const auto &component : points.stress)
    sum += component[p];
  for (const auto &slot : points.history)
    sum += slot[p];
  return sum + points.cell[p];
}

template <int dim>
void
test()
{
  Mesh::BackgroundMesh<dim>   mesh(JitteredBox<dim>(3), "");
  const Mesh::Partition<dim>  partition({}, mesh, MPI_COMM_SELF);
  Points::MaterialPoints<dim> points(mesh, partition, {"first", "second"});
  std::vector<Point<dim>>     places(500);
  for (unsigned int i = 0; i < places.size(); ++i)
    for (unsigned int d = 0; d < dim; ++d)
      places[i][d] = scattered(dim * i + d);
  points.insert(seeds_at(mesh, places, .002), 1, 1500.);
  std::cout << dim << "D: in the handler "
            << points.handler().n_global_particles();
  points.load();
  auto &arrays = points.arrays();
  std::cout << ", loaded " << arrays.size() << ", left in the handler "
            << points.handler().n_global_particles() << std::endl;

  double mass = 0.;
  for (unsigned int p = 0; p < arrays.size(); ++p)
    {
      mass += arrays.mass[p];
      for (unsigned int d = 0; d < dim; ++d)
        arrays.velocity[d][p] = scattered(7 * arrays.id[p] + d);
      for (auto &component : arrays.stress)
        component[p] = scattered(11 * arrays.id[p]);
      for (auto &slot : arrays.history)
        slot[p] = scattered(13 * arrays.id[p]);
    }
  std::cout << "mass " << mass << ", properties "
            << points.property_names().size() << std::endl;

  std::vector<double> before(arrays.size());
  for (unsigned int p = 0; p < arrays.size(); ++p)
    before[arrays.id[p]] = fingerprint(arrays, p);
  points.publish();
  points.load();
  unsigned int n_changed = 0;
  for (unsigned int p = 0; p < arrays.size(); ++p)
    n_changed += before[arrays.id[p]] != fingerprint(arrays, p);
  std::cout << "in order "
            << std::is_sorted(arrays.cell.begin(), arrays.cell.end())
            << ", changed on the way: " << n_changed << std::endl;

  // Out of order, and two lost.
  for (unsigned int p = 0; p + 100 < arrays.size(); p += 7)
    arrays.for_each_array(
      [&](auto &array) { std::swap(array[p], array[p + 100]); });
  points.order();
  n_changed = 0;
  for (unsigned int p = 0; p < arrays.size(); ++p)
    n_changed += before[arrays.id[p]] != fingerprint(arrays, p);
  std::cout << "ordered "
            << std::is_sorted(arrays.cell.begin(), arrays.cell.end())
            << ", changed: " << n_changed << std::endl;
  arrays.cell[10] = arrays.cell[20] = Mesh::no_cell;
  std::cout << "removed " << points.remove_lost() << ", left " << arrays.size()
            << std::endl;
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
