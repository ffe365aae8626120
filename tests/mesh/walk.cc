// Walking and searching find the same cells; what is outside is not found, what
// is outside by round-off only is.

#include <deal.II/base/mpi.h>

#include "../box_mesh.h"
#include "../jittered_box.h"

#include <mpm_granular/mesh/point_walk.h>

#include <iostream>

using namespace Test;

template <int dim, class Cell>
void
test(const Mesh::MeshSource<dim> &source)
{
  const Mesh::BackgroundMesh<dim> mesh(source, "");
  const auto                     &cells = mesh.template cells<Cell>();

  unsigned int            n_wrong = 0, n_found = 0, start = 0;
  std::vector<Point<dim>> places(2000);
  for (unsigned int i = 0; i < places.size(); ++i)
    for (unsigned int d = 0; d < dim; ++d)
      places[i][d] = scattered(dim * i + d);
  const auto located = mesh.locate(places);
  for (unsigned int i = 0; i < places.size(); ++i)
    {
      const auto host = Mesh::walk_to(cells, places[i], start);
      n_found += host.cell != Mesh::no_cell;
      const auto heights = cells[host.cell].heights(places[i]);
      n_wrong += host.cell != located[i] || host.is_beyond_reach ||
                 *std::min_element(heights.begin(), heights.end()) < -1e-12;
      start = host.cell;
    }
  std::cout << dim << "D: found " << n_found << ", wrong " << n_wrong
            << std::endl;

  // The middle of the box's upper side, and a little above.
  Point<dim> top;
  for (unsigned int d = 0; d < dim; ++d)
    top[d] = .5;
  top[dim - 1]      = 1.;
  const auto inside = [&](const double above) {
    Point<dim> x = top;
    x[dim - 1] += above;
    return Mesh::walk_to(cells, x, 0).cell != Mesh::no_cell;
  };
  std::cout << "on the surface " << inside(0.) << ", outside by 1e-9 "
            << inside(1e-9) << ", by 1e-3 " << inside(1e-3) << ", located "
            << (mesh.locate({top})[0] != Mesh::no_cell) << std::endl;

  // Every cell can be reached from every other: all of them from the first.
  unsigned int n_reached = 0;
  for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    n_reached +=
      Mesh::walk_to(cells, mesh.cell_iterator(c)->center(), 0).cell == c;
  std::cout << "all cells reached: " << (n_reached == mesh.n_cells())
            << std::endl;
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2, Mesh::SimplexCell<2>>(JitteredBox<2>(6));
  test<3, Mesh::SimplexCell<3>>(JitteredBox<3>(6));
  test<2, Mesh::BoxCell<2>>(BoxMesh<2>("hypercubes", 6));
  test<3, Mesh::BoxCell<3>>(BoxMesh<3>("hypercubes", 6));
}
