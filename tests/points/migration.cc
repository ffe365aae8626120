// Points that have come to cells of other ranks go there, whole; also after the
// cells have been shared out anew. All of them, and each once.

#include <deal.II/base/mpi.h>

#include "../box_mesh.h"
#include "../jittered_box.h"
#include "../seeds.h"

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

/// Cells of the points at their new places, to which these have not walked.
template <int dim>
void
relocate(const Mesh::BackgroundMesh<dim> &mesh,
         Points::PointArrays<dim>        &arrays)
{
  // The owner of a place on another rank is found by asking all.
  const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  std::vector<Point<dim>> places;
  for (unsigned int p = 0; p < arrays.size(); ++p)
    places.push_back(arrays.location(p));
  const auto all_places = Utilities::MPI::all_gather(MPI_COMM_WORLD, places);
  for (unsigned int rank = 0; rank < n_ranks; ++rank)
    {
      auto global = mesh.locate(all_places[rank]);
      for (unsigned int &cell : global)
        cell = cell < mesh.n_cells() ? mesh.global_cell(cell) : 0;
      Utilities::MPI::max(global, MPI_COMM_WORLD, global);
      if (rank == Utilities::MPI::this_mpi_process(MPI_COMM_WORLD))
        arrays.cell = global;
    }
}

template <int dim>
void
test(const Mesh::MeshSource<dim> &source)
{
  Mesh::BackgroundMesh<dim>   mesh(source, "");
  Mesh::Partition<dim>        partition({}, mesh, MPI_COMM_WORLD);
  Points::MaterialPoints<dim> points(mesh, partition, {"first", "second"});
  std::vector<Point<dim>>     places(500);
  for (unsigned int i = 0; i < places.size(); ++i)
    for (unsigned int d = 0; d < dim; ++d)
      places[i][d] = scattered(dim * i + d);
  points.insert(seeds_at(mesh, places, .002), 3, 1500.);
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
    }
  relocate(mesh, arrays);
  points.send_home();
  report("mirrored", partition, points);

  // Most points into a corner, so that some ranks have none in their cells.
  for (unsigned int p = 0; p < arrays.size(); ++p)
    {
      for (unsigned int d = 0; d < dim; ++d)
        arrays.position[d][p] *= .2;
    }
  relocate(mesh, arrays);
  points.send_home();
  report("in a corner", partition, points);
  const auto n_points = points.count_by_cell();
  points.release();
  partition.distribute(n_points);
  points.send_home();
  report("shared out anew", partition, points);
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>(JitteredBox<2>(4));
  test<3>(JitteredBox<3>(4));
  test<2>(BoxMesh<2>("hypercubes", 8));
  test<3>(BoxMesh<3>("hypercubes", 8));
}
