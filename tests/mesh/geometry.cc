// The flat copy of the mesh: volumes, shape functions, neighbours, surface.

#include "../jittered_box.h"

#include <mpm_granular/mesh/point_walk.h>

#include <iostream>
#include <numeric>

using namespace Test;

template <int dim>
void
test()
{
  const Mesh::BackgroundMesh<dim> mesh(JitteredBox<dim>(4), "");

  double       volume = 0., worst_value = 0., worst_gradient = 0.;
  unsigned int n_wrong_neighbors = 0, n_beyond = 0;
  for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      const auto &cell = mesh.cell(c);
      volume += mesh.cell_volume(c);
      Tensor<1, dim> sum;
      for (unsigned int k = 0; k <= dim; ++k)
        {
          const auto values =
            cell.shape_values(mesh.node_position(cell.node[k]));
          for (unsigned int j = 0; j <= dim; ++j)
            worst_value = std::max(worst_value, std::abs(values[j] - (j == k)));
          sum += cell.shape_gradient(k);

          // A neighbour shares all nodes but the opposite one.
          if (cell.neighbor[k] == Mesh::no_cell)
            {
              ++n_beyond;
              continue;
            }
          const auto  &other    = mesh.cell(cell.neighbor[k]).node;
          unsigned int n_shared = 0;
          for (unsigned int j = 0; j <= dim; ++j)
            n_shared += std::count(other.begin(), other.end(), cell.node[j]);
          n_wrong_neighbors +=
            n_shared != dim ||
            std::count(other.begin(), other.end(), cell.node[k]) > 0;
        }
      worst_gradient = std::max(worst_gradient, sum.norm());
    }
  double         area = 0.;
  Tensor<1, dim> vector_area;
  for (const auto &face : mesh.boundary_faces())
    {
      area += face.area;
      vector_area += face.area * face.normal;
    }
  std::cout << dim << "D: volume " << volume << ", surface " << area
            << ", closed " << (vector_area.norm() < 1e-12) << std::endl
            << "nodal values are Kronecker's: " << (worst_value < 1e-12)
            << ", gradients sum to zero: " << (worst_gradient < 1e-12)
            << std::endl
            << "wrong neighbours: " << n_wrong_neighbors
            << ", faces without neighbour are the surface: "
            << (n_beyond == mesh.boundary_faces().size()) << std::endl;
}

int
main()
{
  test<2>();
  test<3>();
}
