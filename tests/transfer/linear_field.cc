// Grid to points: a linear velocity field on the nodes moves points exactly,
// changes their velocities exactly and has its constant gradient in every cell;
// the points end in the cells that hold them.

#include <deal.II/base/mpi.h>

#include "scattered_points.h"

#include <iostream>

using namespace Test;

template <int dim>
void
test(const Mesh::MeshSource<dim> &source)
{
  ScatteredPoints<dim> test(source, [](const Point<dim> &) {
    return Tensor<1, dim>();
  });
  test.project();

  Tensor<2, dim> gradient;
  Tensor<1, dim> constant;
  for (unsigned int i = 0; i < dim; ++i)
    {
      constant[i] = .1 * (i + 1);
      for (unsigned int j = 0; j < dim; ++j)
        gradient[i][j] = scattered(3 * i + j) - .5;
    }
  auto &fields = test.fields;
  for (unsigned int i = 0; i < fields.n_active_nodes(); ++i)
    {
      const Tensor<1, dim> v =
        constant + gradient * test.mesh.node_position(fields.active_nodes[i]);
      fields.motion[i] = {v, 2. * v, 3. * v};
    }

  // Far enough that most points leave their cells.
  const double time_step = dim == 2 ? .15 : .08, pic_factor = .25;
  auto        &points      = test.points.arrays();
  double       worst_place = 0., worst_velocity = 0., worst_gradient = 0.;
  unsigned int n_moved = 0, n_wrong_cells = 0, n_lost = 0, n_wrong_runs = 0;
  for (unsigned int p = 0; p < points.size(); ++p)
    points.velocity[0][p] = 1.;
  std::vector<Point<dim>> old_places;
  for (unsigned int p = 0; p < points.size(); ++p)
    old_places.push_back(points.location(p));
  const auto old_cells = points.cell;

  test.for_each_block([&] {
    auto &block = test.block;
    Transfer::evaluate_gradients(test.mesh, fields, points, block);
    for (const auto &of_points : block.gradients)
      worst_gradient =
        std::max(worst_gradient, (of_points - 3. * gradient).norm());
    unsigned int end = block.begin;
    for (const auto &strained : block.strained)
      {
        n_wrong_runs += strained.begin != end;
        end = strained.end;
      }
    n_wrong_runs +=
      end != block.end || block.strained.size() != block.gradients.size();
    Transfer::move_points(
      test.mesh, fields, block, time_step, pic_factor, points);
    n_lost +=
      Transfer::relocate(test.mesh, test.partition, points, block).lost_point !=
      Transfer::no_point;
    for (unsigned int p = block.begin; p < block.end; ++p)
      {
        test.mesh.visit([&](const auto &cells) {
          const auto values =
            cells[points.cell[p]].shape_values(points.location(p));
          for (unsigned int k = 0; k < values.size(); ++k)
            n_wrong_cells +=
              values[k] < -1e-9 ||
              std::abs(values[k] - block.shape_values[k][p - block.begin]) >
                1e-8;
        });
      }
  });
  for (unsigned int p = 0; p < points.size(); ++p)
    {
      const Tensor<1, dim> v        = constant + gradient * old_places[p];
      Tensor<1, dim>       velocity = 2. * v;
      velocity[0] += .75;
      for (unsigned int d = 0; d < dim; ++d)
        velocity[d] -= points.velocity[d][p];
      worst_velocity = std::max(worst_velocity, velocity.norm());
      worst_place =
        std::max(worst_place,
                 (points.location(p) - old_places[p] - time_step * v).norm());
      n_moved += points.cell[p] != old_cells[p];
    }
  std::cout << dim << "D: places exact " << (worst_place < 1e-13)
            << ", velocities exact " << (worst_velocity < 1e-13)
            << ", gradients exact " << (worst_gradient < 1e-12) << std::endl
            << "many changed cells " << (n_moved > 300) << ", wrong cells "
            << n_wrong_cells << ", lost " << n_lost << ", wrong runs "
            << n_wrong_runs << std::endl;
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>(JitteredBox<2>(4));
  test<3>(JitteredBox<3>(4));
  test<2>(BoxMesh<2>("hypercubes", 6));
  test<3>(BoxMesh<3>("hypercubes", 6));
}
