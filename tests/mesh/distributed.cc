// A mesh of hypercubes that p4est shares out: global numbers belong to the same
// places on all ranks before and after it is shared out anew, each place has
// one owner, and what ghosts cannot know of their surroundings is completed by
// their owners.

#include <deal.II/base/mpi.h>

#include "../box_mesh.h"

#include <mpm_granular/mesh/partition.h>

#include <iostream>
#include <set>

using namespace Test;

/// Ranks may make a vertex in the middle of others in another order.
constexpr double round_off = 1e-14;

/// Centres of the cells of all ranks by their global numbers; what is not the
/// same on all ranks that know a cell counts as wrong.
template <int dim>
std::vector<double>
centers(const Mesh::BackgroundMesh<dim> &mesh, unsigned int &n_wrong)
{
  constexpr double    nowhere = 1e10;
  std::vector<double> lowest(dim * mesh.n_global_cells(), nowhere);
  std::vector<double> highest(dim * mesh.n_global_cells(), -nowhere);
  for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
    for (unsigned int d = 0; d < dim; ++d)
      {
        const unsigned int i = dim * mesh.global_cell(cell) + d;
        lowest[i] = highest[i] = mesh.cell_iterator(cell)->center()[d];
        n_wrong += mesh.local_cell(mesh.global_cell(cell)) != cell;
      }
  Utilities::MPI::min(lowest, MPI_COMM_WORLD, lowest);
  Utilities::MPI::max(highest, MPI_COMM_WORLD, highest);
  for (unsigned int i = 0; i < lowest.size(); ++i)
    n_wrong += lowest[i] == nowhere || highest[i] - lowest[i] > round_off;
  return lowest;
}

template <int dim>
void
test()
{
  constexpr unsigned int    n = 12;
  Mesh::BackgroundMesh<dim> mesh(BoxMesh<dim>("hypercubes", n), "");
  Mesh::Partition<dim>      partition(Mesh::PartitionParameters(),
                                 mesh,
                                 MPI_COMM_WORLD);

  unsigned int n_wrong = 0, n_wrong_owners = 0, n_wrong_nodes = 0;
  const auto   before = centers(mesh, n_wrong);
  // All points are in a corner.
  std::vector<std::uint32_t> n_points(mesh.n_cells(), 0);
  std::uint32_t              total     = 0;
  const auto                 points_in = [](const Point<dim> &x) {
    return x[0] < .34 && x[dim - 1] < .34 ? 8 : 0;
  };
  for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
    n_points[cell] = points_in(mesh.cell_iterator(cell)->center());
  partition.distribute(n_points);
  const auto after = centers(mesh, n_wrong);
  for (unsigned int i = 0; i < before.size(); ++i)
    n_wrong += std::abs(before[i] - after[i]) > round_off;

  // p4est keeps the children of a cell together.
  constexpr std::uint32_t family = 8 << dim;
  std::uint32_t           most   = 0;
  for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
    {
      n_wrong_owners +=
        partition.is_owned(cell) !=
          (partition.owner(mesh.global_cell(cell)) == partition.rank) ||
        partition.is_owned(cell) !=
          mesh.cell_iterator(cell)->is_locally_owned();
      if (partition.is_owned(cell))
        most += points_in(mesh.cell_iterator(cell)->center());
    }
  total = Utilities::MPI::sum(most, MPI_COMM_WORLD);
  most  = Utilities::MPI::max(most, MPI_COMM_WORLD);

  // The exact surroundings of a node of the box, also at ghosts.
  for (unsigned int node = 0; node < mesh.n_nodes(); ++node)
    {
      const Point<dim> &x        = mesh.node_position(node);
      double            volume   = std::pow(1. / n, dim);
      unsigned int      n_planes = 0;
      for (unsigned int d = 0; d < dim; ++d)
        if (x[d] < 1e-9 || x[d] > 1. - 1e-9)
          {
            volume /= 2.;
            ++n_planes;
          }
      std::set<types::boundary_id> planes;
      for (const auto &face : mesh.boundary_faces())
        if (std::count(face.node.begin(), face.node.end(), node) > 0)
          planes.insert(face.boundary);
      n_wrong_nodes += std::abs(mesh.node_volume(node) / volume - 1.) > 1e-12 ||
                       planes.size() != n_planes;
    }

  // Places anywhere, also on faces between cells and outside.
  std::vector<Point<dim>> places;
  for (unsigned int i = 0; i <= 30; ++i)
    for (unsigned int j = 0; j <= 30; ++j)
      {
        Point<dim> x;
        x[0]       = i / 24.;
        x[dim - 1] = j / 24.;
        places.push_back(x);
      }
  unsigned int              n_wrong_places = 0;
  const auto                found          = mesh.locate(places);
  std::vector<unsigned int> n_owners(places.size());
  for (unsigned int i = 0; i < places.size(); ++i)
    {
      n_owners[i] = found[i] < mesh.n_cells();
      n_wrong_places +=
        n_owners[i] &&
        !mesh.cell_iterator(found[i])->bounding_box().point_inside(places[i],
                                                                   1e-9);
      n_wrong_places += (found[i] == Mesh::no_cell) !=
                        (places[i][0] > 1. || places[i][dim - 1] > 1.);
    }
  Utilities::MPI::sum(n_owners, MPI_COMM_WORLD, n_owners);
  for (unsigned int i = 0; i < places.size(); ++i)
    n_wrong_places +=
      n_owners[i] != (places[i][0] <= 1. && places[i][dim - 1] <= 1.);

  for (unsigned int *number :
       {&n_wrong, &n_wrong_owners, &n_wrong_nodes, &n_wrong_places})
    *number = Utilities::MPI::sum(*number, MPI_COMM_WORLD);
  if (partition.rank == 0)
    std::cout << dim << "D: cells " << mesh.n_global_cells() << ", nodes "
              << mesh.n_global_nodes() << ", wrong: cells " << n_wrong
              << ", owners " << n_wrong_owners << ", nodes " << n_wrong_nodes
              << ", places " << n_wrong_places << std::endl
              << "points shared out evenly: "
              << (most <= total / partition.n_ranks + family) << std::endl;
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
