// Points to grid keeps mass and linear and angular momentum; internal forces
// add up to no force and no moment; masses are the row sums of the sampled mass
// matrix.

#include <deal.II/base/mpi.h>

#include "scattered_points.h"

#include <iostream>

using namespace Test;

template <int dim>
Tensor<1, dim == 2 ? 1 : 3>
moment(const Point<dim> &x, const Tensor<1, dim> &f)
{
  Tensor<1, dim == 2 ? 1 : 3> result;
  if constexpr (dim == 2)
    result[0] = x[0] * f[1] - x[1] * f[0];
  else
    result = cross_product_3d(x, f);
  return result;
}

template <int dim>
void
test(const Mesh::MeshSource<dim> &source)
{
  ScatteredPoints<dim> test(source, [](const Point<dim> &x) {
    Tensor<1, dim> v;
    for (unsigned int d = 0; d < dim; ++d)
      v[d] = std::sin(5. * x[d]) + x[(d + 1) % dim];
    return v;
  });
  test.project();

  const auto                 &points = test.points.arrays();
  double                      mass   = 0.;
  Tensor<1, dim>              momentum;
  Tensor<1, dim == 2 ? 1 : 3> angular;
  for (unsigned int p = 0; p < points.size(); ++p)
    {
      Tensor<1, dim> mv;
      for (unsigned int d = 0; d < dim; ++d)
        mv[d] = points.mass[p] * points.velocity[d][p];
      mass += points.mass[p];
      momentum += mv;
      angular += moment<dim>(points.location(p), mv);
    }
  const double      scale_mass = mass, scale = momentum.norm();
  double            largest_force = 0.;
  Tensor<1, dim>    force;
  decltype(angular) torque;
  auto             &fields = test.fields;
  for (unsigned int i = 0; i < fields.n_active_nodes(); ++i)
    {
      const auto &node = fields.sums[i];
      mass -= node.mass;
      momentum -= node.momentum;
      angular -= moment<dim>(test.mesh.node_position(fields.active_nodes[i]),
                             node.momentum);
      force += node.force;
      torque += moment<dim>(test.mesh.node_position(fields.active_nodes[i]),
                            node.force);
      largest_force = std::max(largest_force, node.force.norm());
    }
  std::vector<Tensor<1, dim>> ones(fields.n_active_nodes()), rows(ones.size());
  for (auto &one : ones)
    one[0] = 1.;
  fields.add_mass_times(ones, rows);
  double worst_row = 0.;
  for (unsigned int i = 0; i < ones.size(); ++i)
    worst_row = std::max(worst_row, std::abs(rows[i][0] - fields.sums[i].mass));

  std::cout << dim << "D: mass kept " << (std::abs(mass) < 1e-12 * scale_mass)
            << ", momentum kept " << (momentum.norm() < 1e-12 * scale)
            << ", angular momentum kept " << (angular.norm() < 1e-11 * scale)
            << std::endl
            << "no net force " << (force.norm() < 1e-12 * largest_force)
            << ", no net moment " << (torque.norm() < 1e-12 * largest_force)
            << ", there are forces " << (largest_force > 1e-3) << std::endl
            << "row sums are masses " << (worst_row < 1e-12 * scale_mass)
            << std::endl;
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>(JitteredBox<2>(4));
  test<3>(JitteredBox<3>(4));
  test<2>(BoxMesh<2>("hypercubes", 8));
  test<3>(BoxMesh<3>("hypercubes", 6));
}
