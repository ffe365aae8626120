// Points that have come to cells of other ranks go there, whole; also after the
// cells have been shared out anew. All of them, and each once.

#include <deal.II/base/mpi.h>

#include "../jittered_box.h"

#include <mpm_granular/points/material_points.h>

#include <iostream>

using namespace Test;

/// Number, and sums that tell points and their arrays apart; and whether all
/// points are where they belong.
template <int dim>
void
report(const std::string                 &when,
       const Mesh::Partition<dim>        &partition,
       const Points::MaterialPoints<dim> &points)
{
  const auto         &arrays = points.arrays();
  std::vector<double> sums(4, 0.);
  bool                at_home = true;
  for (unsigned int p = 0; p < arrays.size(); ++p)
    {
      const double key = 1. + arrays.id[p];
      sums[0] += 1.;
      sums[1] += key;
      sums[2] += key * arrays.history[1][p];
      sums[3] += key * arrays.position[0][p] * arrays.material[p];
      at_home = at_home && partition.is_owned(arrays.cell[p]) &&
                points.arrays().stress[0][p] == -key;
    }
  Utilities::MPI::sum(sums, partition.communicator, sums);
  at_home = Utilities::MPI::min(at_home ? 1 : 0, partition.communicator) == 1;
  if (partition.rank == 0)
    std::cout << when << ": " << sums[0] << " points, sums " << sums[1] * 1e-4
              << ' ' << sums[2] * 1e-4 << ' ' << sums[3] * 1e-4
              << ", all at home " << at_home << std::endl;
}

template <int dim>
void
test()
{
  const Mesh::BackgroundMesh<dim> mesh(JitteredBox<dim>(4), "");
  Mesh::Partition<dim>            partition({}, mesh, MPI_COMM_WORLD);
  Points::MaterialPoints<dim>     points(mesh, partition, {"first", "second"});
  std::vector<Points::Seed<dim>>  seeds;
  for (unsigned int i = 0; i < 500; ++i)
    {
      Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = scattered(dim * i + d);
      seeds.push_back({x, mesh.locate(x), .002});
    }
  points.insert(seeds, 3, 1500.);
  points.load();
  auto &arrays = points.arrays();
  for (unsigned int p = 0; p < arrays.size(); ++p)
    {
      arrays.stress[0][p]  = -1. - arrays.id[p];
      arrays.history[1][p] = scattered(arrays.id[p]);
    }
  report(std::to_string(dim) + "D, at the start", partition, points);

  // To the opposite side.
  for (unsigned int p = 0; p < arrays.size(); ++p)
    {
      arrays.position[0][p] = 1. - arrays.position[0][p];
      arrays.cell[p]        = mesh.locate(arrays.location(p));
    }
  points.migrate();
  report("mirrored", partition, points);

  // Most points into a corner, so that some ranks have none in their cells.
  for (unsigned int p = 0; p < arrays.size(); ++p)
    {
      for (unsigned int d = 0; d < dim; ++d)
        arrays.position[d][p] *= .2;
      arrays.cell[p] = mesh.locate(arrays.location(p));
    }
  points.migrate();
  report("in a corner", partition, points);
  partition.distribute(points.count_by_cell());
  points.migrate();
  report("shared out anew", partition, points);
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
