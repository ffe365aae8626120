// The flat copy of the mesh: volumes, shape functions, neighbours, surface.

#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>

#include "../box_mesh.h"
#include "../jittered_box.h"

#include <mpm_granular/mesh/point_walk.h>

#include <iostream>
#include <numeric>

using namespace Test;

/// The unit box in hypercubes, sheared; or bent, if asked for, so that cells
/// are not box-like any more.
template <int dim>
class SkewBox : public BoxMesh<dim>
{
public:
  explicit SkewBox(const double bend = 0.)
    : BoxMesh<dim>("hypercubes", 4)
    , bend(bend)
  {}

  Mesh::MeshNames
  make(Triangulation<dim> &triangulation,
       const std::string  &file) const override
  {
    const auto names = BoxMesh<dim>::make(triangulation, file);
    GridTools::transform(
      [&](const Point<dim> &x) {
        Point<dim> moved = x;
        moved[0] += .5 * x[1] + bend * x[0] * x[1];
        return moved;
      },
      triangulation);
    return names;
  }

private:
  const double bend;
};

template <int dim, class Cell>
void
test(const Mesh::MeshSource<dim> &source)
{
  const Mesh::BackgroundMesh<dim> mesh(source, "");
  const auto                     &cells = mesh.template cells<Cell>();

  double       volume = 0., worst_value = 0., worst_gradient = 0.;
  unsigned int n_wrong_neighbors = 0, n_beyond = 0;
  for (unsigned int c = 0; c < mesh.n_cells(); ++c)
    {
      const Cell &cell = cells[c];
      volume += mesh.cell_volume(c);
      Tensor<1, dim> sum;
      Tensor<2, dim> identity; // sum_k x_k grad N_k, as x is linear
      for (unsigned int k = 0; k < Cell::n_nodes; ++k)
        {
          const Point<dim> &x      = mesh.node_position(cell.node[k]);
          const auto        values = cell.shape_values(x);
          for (unsigned int j = 0; j < Cell::n_nodes; ++j)
            worst_value = std::max(worst_value, std::abs(values[j] - (j == k)));
          sum += cell.central_gradient(k);
          identity += outer_product(x, cell.central_gradient(k));
        }
      for (unsigned int d = 0; d < dim; ++d)
        identity[d][d] -= 1.;
      worst_gradient = std::max({worst_gradient, sum.norm(), identity.norm()});
      for (unsigned int f = 0; f < Cell::n_faces; ++f)
        {
          // A neighbour shares the nodes of the face, and no others.
          if (cell.neighbor[f] == Mesh::no_cell)
            {
              ++n_beyond;
              continue;
            }
          const auto &other = cells[cell.neighbor[f]].node;
          for (unsigned int k = 0; k < Cell::n_nodes; ++k)
            n_wrong_neighbors +=
              std::count(other.begin(), other.end(), cell.node[k]) !=
              Cell::is_on_face(k, f);
        }
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
            << ", gradients of 1 and x exact: " << (worst_gradient < 1e-12)
            << std::endl
            << "wrong neighbours: " << n_wrong_neighbors
            << ", faces without neighbour are the surface: "
            << (n_beyond == mesh.boundary_faces().size()) << std::endl;
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2, Mesh::SimplexCell<2>>(JitteredBox<2>(4));
  test<3, Mesh::SimplexCell<3>>(JitteredBox<3>(4));
  test<2, Mesh::BoxCell<2>>(SkewBox<2>());
  test<3, Mesh::BoxCell<3>>(SkewBox<3>());

  try
    {
      Mesh::BackgroundMesh<2>(SkewBox<2>(.1), "");
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}
