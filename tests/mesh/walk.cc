// Walking and searching find the same cells; what is outside is not found, what
// is outside by round-off only is.

#include "../jittered_box.h"

#include <mpm_granular/mesh/point_walk.h>

#include <iostream>

using namespace Test;

template <int dim>
void
test()
{
  const Mesh::BackgroundMesh<dim> mesh(JitteredBox<dim>(6), "");

  unsigned int n_wrong = 0, n_found = 0, start = 0;
  for (unsigned int i = 0; i < 2000; ++i)
    {
      Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = scattered(dim * i + d);
      const auto host = Mesh::walk_to(mesh, x, start);
      n_found += host.cell != Mesh::no_cell;
      n_wrong += host.cell != mesh.locate(x) ||
                 *std::min_element(host.shape_values.begin(),
                                   host.shape_values.end()) < -1e-12;
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
    return Mesh::walk_to(mesh, x, 0).cell != Mesh::no_cell;
  };
  std::cout << "on the surface " << inside(0.) << ", outside by 1e-9 "
            << inside(1e-9) << ", by 1e-3 " << inside(1e-3) << ", located "
            << (mesh.locate(top) != Mesh::no_cell) << std::endl;

  // Every cell can be reached from every other: all of them from the first.
  unsigned int n_reached = 0;
  for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    n_reached +=
      Mesh::walk_to(mesh, mesh.cell_iterator(c)->center(), 0).cell == c;
  std::cout << "all cells reached: " << (n_reached == mesh.n_cells())
            << std::endl;
}

int
main()
{
  test<2>();
  test<3>();
}
