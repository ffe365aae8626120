// A mesh that is refined and coarsened again and again is the same on any
// number of ranks; cells that touch differ by one level; every place is in a
// cell that a walk from any other finds; the refinement tree brings it back,
// and without refinement it is the mesh that was given.

#include <deal.II/base/mpi.h>

#include "../box_mesh.h"
#include "../jittered_box.h"

#include <mpm_granular/mesh/fingerprint.h>
#include <mpm_granular/mesh/partition.h>
#include <mpm_granular/mesh/point_walk.h>

#include <cmath>
#include <cstdint>
#include <iostream>
#include <map>

using namespace Test;

/// Levels wanted around a place that goes around in circles.
template <int dim>
std::vector<std::uint8_t>
wanted(const Mesh::BackgroundMesh<dim> &mesh, const double time)
{
  Point<dim> center;
  center[0] = .5 + .3 * std::cos(time);
  center[1] = .5 + .3 * std::sin(time);
  if (dim == 3)
    center[dim - 1] = .4;
  std::vector<std::uint8_t> levels;
  for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
    {
      const double distance =
        mesh.cell_iterator(cell)->center().distance(center);
      levels.push_back(distance < .15 ? 2 : distance < .3 ? 1 : 0);
    }
  return levels;
}

/// The largest difference of levels of cells of this rank with a common vertex.
template <int dim>
unsigned int
largest_jump(const Mesh::BackgroundMesh<dim> &mesh)
{
  std::vector<unsigned int> lowest(mesh.n_nodes(), 100), highest(lowest.size());
  unsigned int              jump = 0;
  for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
    for (const unsigned int node : mesh.nodes(cell))
      {
        lowest[node]  = std::min(lowest[node], mesh.level(cell));
        highest[node] = std::max(highest[node], mesh.level(cell));
        jump          = std::max(jump, highest[node] - lowest[node]);
      }
  return jump;
}

/// Whether a walk from the first cell of this rank finds the cells of others by
/// their centres (or where it ends here).
template <int dim>
bool
can_be_walked(const Mesh::BackgroundMesh<dim> &mesh)
{
  bool is_found = true;
  mesh.visit([&](const auto &cells) {
    for (unsigned int cell = 0; cell < mesh.n_own_cells(); ++cell)
      {
        const auto found =
          Mesh::walk_to(cells, mesh.cell_iterator(cell)->center(), 0);
        is_found = is_found && (found.cell == cell || found.is_beyond_reach);
      }
  });
  return is_found;
}

template <int dim>
void
test(const std::string &name, const Mesh::MeshSource<dim> &source)
{
  Mesh::BackgroundMesh<dim> mesh(source, "");
  Mesh::Partition<dim>      partition(Mesh::PartitionParameters(),
                                 mesh,
                                 MPI_COMM_WORLD);
  const auto                share_out = [&](Mesh::Partition<dim> &whose,
                             const unsigned int    n_cells) {
    whose.distribute(std::vector<std::uint32_t>(n_cells, 1));
  };
  const auto fingerprint_of = [](const Mesh::BackgroundMesh<dim> &of) {
    return Mesh::fingerprint(of, MPI_COMM_WORLD);
  };
  const std::uint64_t given = fingerprint_of(mesh);

  bool          is_balanced = true, is_found = true, is_followed = true;
  std::uint64_t n_cells = 0;
  std::size_t   memory  = 0;
  for (unsigned int i = 0; i < 40; ++i)
    {
      std::vector<Point<dim>> centers;
      for (unsigned int cell = 0; cell < mesh.n_own_cells(); ++cell)
        centers.push_back(mesh.cell_iterator(cell)->center());
      if (const auto cells = mesh.adapt(wanted(mesh, .2 * i)))
        {
          mesh.visit([&](const auto &all) {
            for (unsigned int cell = 0; cell < centers.size(); ++cell)
              is_followed =
                is_followed &&
                Mesh::walk_to(all, centers[cell], (*cells)[cell]).cell <
                  mesh.n_own_cells();
          });
          share_out(partition, mesh.n_cells());
        }
      is_balanced = is_balanced && largest_jump(mesh) <= 1;
      is_found    = is_found && can_be_walked(mesh);
      n_cells += mesh.n_global_cells();
      if (i == 20)
        memory = mesh.memory_consumption();
    }
  const bool is_flat = mesh.memory_consumption() < 1.3 * memory;

  const auto                tree = mesh.refinement_tree();
  Mesh::BackgroundMesh<dim> again(source, "");
  Mesh::Partition<dim>      its_partition(Mesh::PartitionParameters(),
                                     again,
                                     MPI_COMM_WORLD);
  again.set_refinement_tree(tree);
  share_out(its_partition, again.n_cells());
  const bool is_grown = fingerprint_of(mesh) == fingerprint_of(again) &&
                        again.refinement_tree() == tree;

  while (mesh.adapt(std::vector<std::uint8_t>(mesh.n_cells(), 0)))
    share_out(partition, mesh.n_cells());
  const bool is_given = fingerprint_of(mesh) == given;

  const auto on_all = [](const bool value) {
    return !Utilities::MPI::logical_or(!value, MPI_COMM_WORLD);
  };
  const bool all[] = {on_all(is_balanced),
                      on_all(is_found),
                      on_all(is_followed),
                      on_all(is_flat),
                      on_all(is_grown),
                      on_all(is_given)};
  if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    std::cout << name << ": cells " << n_cells << ", finest "
              << int(*std::max_element(tree.begin(), tree.end()))
              << ", jumps of one level " << all[0] << ", walked " << all[1]
              << ", followed " << all[2] << ", memory flat " << all[3]
              << ", brought back " << all[4] << ", as given " << all[5]
              << std::endl;
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>("triangles", JitteredBox<2>(6));
  test<3>("tetrahedra", JitteredBox<3>(4));
  test<2>("squares", BoxMesh<2>("hypercubes", 6));
  test<3>("cubes", BoxMesh<3>("hypercubes", 5));
}
