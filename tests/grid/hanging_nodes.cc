// On meshes of several levels: a linear velocity field has its constant
// gradient in every cell; masses, momenta and forces of the points come to the
// free nodes, with nothing lost; a constant stress in all of space makes no
// force within the body; the mass matrix is that of the points.

#include "../transfer/scattered_points.h"

#include <iostream>

using namespace Test;

template <int dim>
void
test(const std::string &name, const Mesh::MeshSource<dim> &source)
{
  Tensor<2, dim> slope;
  Tensor<1, dim> offset;
  for (unsigned int i = 0; i < dim; ++i)
    {
      offset[i] = 1. + i;
      for (unsigned int j = 0; j < dim; ++j)
        slope[i][j] = .3 * i - .7 * j + .1;
    }
  const auto velocity = [&](const Point<dim> &x) -> Tensor<1, dim> {
    return offset + slope * x;
  };
  ScatteredPoints<dim> test(source, velocity);
  Point<dim>           center;
  for (unsigned int d = 0; d < dim; ++d)
    center[d] = .45 + .1 * d;
  test.refine_near(center);
  test.project();
  auto       &fields = test.fields;
  const auto &mesh   = test.mesh;
  const auto &arrays = test.points.arrays();

  unsigned int finest = 0;
  for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
    finest = std::max(finest, mesh.level(cell));

  // The gradient at all points.
  for (unsigned int i = 0; i < fields.n_active_nodes(); ++i)
    fields.motion[i].straining =
      velocity(mesh.node_position(fields.active_nodes[i]));
  fields.extend_motion();
  double worst_gradient = 0.;
  test.for_each_block([&] {
    Transfer::evaluate_gradients(mesh, fields, arrays, test.block);
    for (const auto &gradient : test.block.gradients)
      worst_gradient = std::max(worst_gradient, (gradient - slope).norm());
  });

  // Sums over nodes and over points, of mass, of momentum and its moments; and
  // of forces, which cancel.
  double         mass = 0., mass_of_points = 0., torque = 0.;
  Tensor<1, dim> momentum, momentum_of_points, force;
  for (unsigned int p = 0; p < arrays.size(); ++p)
    {
      mass_of_points += arrays.mass[p];
      for (unsigned int d = 0; d < dim; ++d)
        momentum_of_points[d] += arrays.mass[p] * arrays.velocity[d][p];
    }
  for (unsigned int i = 0; i < fields.n_active_nodes(); ++i)
    {
      const auto &node = fields.sums[i];
      const auto &x    = mesh.node_position(fields.active_nodes[i]);
      mass += node.mass;
      momentum += node.momentum;
      force += node.force;
      torque += x[0] * node.force[1] - x[1] * node.force[0];
    }

  // The lumped masses are the row sums, and a linear field has the momentum of
  // points that move with it.
  const unsigned int          n = fields.n_active_nodes();
  std::vector<Tensor<1, dim>> field(n), result(n), ones(n), rows(n);
  for (unsigned int i = 0; i < n; ++i)
    {
      field[i]   = velocity(mesh.node_position(fields.active_nodes[i]));
      ones[i][0] = 1.;
    }
  fields.add_mass_times(field, result);
  fields.add_mass_times(ones, rows);
  double worst_row = 0., worst_momentum = 0.;
  for (unsigned int i = 0; i < n; ++i)
    {
      worst_row =
        std::max(worst_row, std::abs(rows[i][0] - fields.sums[i].mass));
      worst_momentum =
        std::max(worst_momentum, (result[i] - fields.sums[i].momentum).norm());
    }

  // Forces once more, from the cells.
  std::vector<Tensor<1, dim>> before;
  for (const auto &node : fields.sums)
    before.push_back(node.force);
  fields.gather_forces();
  double worst_force = 0.;
  for (unsigned int i = 0; i < n; ++i)
    worst_force =
      std::max(worst_force, (fields.sums[i].force - before[i]).norm());

  // The volumes of the free nodes fill the mesh.
  double volume = 0.;
  for (unsigned int node = 0; node < mesh.n_nodes(); ++node)
    volume += mesh.node_volume(node);

  std::cout << name << ": levels " << finest << ", hanging nodes "
            << (mesh.hanging_nodes().n_constraints() > 5 &&
                fields.hanging.size() > 5)
            << ", gradient " << (worst_gradient < 1e-12) << ", mass "
            << (std::abs(mass - mass_of_points) < 1e-12 * mass_of_points)
            << ", momentum "
            << ((momentum - momentum_of_points).norm() <
                1e-12 * momentum_of_points.norm())
            << ", no net force " << (force.norm() < 1e-12) << ", no net torque "
            << (std::abs(torque) < 1e-12) << ", row sums "
            << (worst_row < 1e-12 * mass) << ", momentum of a linear field "
            << (worst_momentum < 1e-12 * mass) << ", forces again "
            << (worst_force < 1e-12) << ", volume "
            << (std::abs(volume - 1.) < 1e-12) << std::endl;
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>("triangles", JitteredBox<2>(4));
  test<3>("tetrahedra", JitteredBox<3>(4));
  test<2>("squares", BoxMesh<2>("hypercubes", 5));
  test<3>("cubes", BoxMesh<3>("hypercubes", 5));
}
