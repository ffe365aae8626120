// M_alpha: for alpha = 0 it is the lumped matrix; otherwise the solution
// fulfils the equations with the matrix summed from the cells, keeps prescribed
// components, and leaves a residual (the reaction) in them only.

#include <deal.II/base/parameter_handler.h>

#include "../transfer/scattered_points.h"

#include <mpm_granular/momentum/mass_matrix.h>

#include <iostream>

using namespace Test;

template <int dim>
std::unique_ptr<Momentum::MassMatrix<dim>>
matrix(const std::string    &name,
       const std::string    &alpha,
       ScatteredPoints<dim> &test)
{
  auto             mass = Momentum::MassMatrixRegistry<dim>::make(name);
  ParameterHandler prm;
  mass->add_parameters(prm);
  if (!alpha.empty())
    prm.parse_input_from_string("set Consistent part = " + alpha);
  mass->check();
  mass->reinit(test.mesh);
  mass->assemble(test.fields);
  return mass;
}

template <int dim>
void
test(const Mesh::MeshSource<dim> &source)
{
  ScatteredPoints<dim> test(source, [](const Point<dim> &x) {
    Tensor<1, dim> v;
    for (unsigned int d = 0; d < dim; ++d)
      v[d] = std::sin(5. * x[d]);
    return v;
  });
  test.project();
  auto                       &fields = test.fields;
  const unsigned int          n      = fields.n_active_nodes();
  Momentum::NodalVectors<dim> momentum(n), lumped, same, velocity, image(n);
  for (unsigned int i = 0; i < n; ++i)
    momentum[i] = fields.sums[i].momentum;

  matrix<dim>("lumped", "", test)->solve(momentum, nullptr, lumped);
  matrix<dim>("near-consistent", "0", test)->solve(momentum, nullptr, same);
  double difference = 0.;
  for (unsigned int i = 0; i < n; ++i)
    difference = std::max(difference, (lumped[i] - same[i]).norm());
  std::cout << dim << "D: alpha = 0 is lumped " << (difference < 1e-12)
            << std::endl;

  // A node in two conditions: a skew direction, and all.
  Grid::VelocityConstraints<dim> constraints;
  Tensor<1, dim>                 skew;
  skew[0] = .6;
  skew[1] = -.8;
  Grid::NodeConstraint<dim> one{3, 1, {}, {}};
  one.direction[0] = skew;
  one.target[0]    = .7;
  Grid::NodeConstraint<dim> all{5, dim, {}, {}};
  for (unsigned int d = 0; d < dim; ++d)
    {
      all.direction[d][d] = 1.;
      all.target[d]       = d - .5;
    }
  constraints.nodes = {one, all};

  const double alpha = .75;
  const auto mass = matrix<dim>("near-consistent", std::to_string(alpha), test);
  mass->solve(momentum, &constraints, velocity);
  Momentum::NodalVectors<dim> from_matrix;
  mass->multiply(velocity, from_matrix);
  fields.add_mass_times(velocity, image);
  double scale = 0., residual = 0., of_matrix = 0.;
  for (unsigned int i = 0; i < n; ++i)
    {
      image[i] =
        alpha * image[i] + (1. - alpha) * fields.sums[i].mass * velocity[i];
      of_matrix = std::max(of_matrix, (image[i] - from_matrix[i]).norm());
      scale     = std::max(scale, momentum[i].norm());
      Tensor<1, dim> rest = momentum[i] - image[i];
      if (i == 3)
        rest -= (rest * skew) * skew;
      if (i != 5)
        residual = std::max(residual, rest.norm());
    }
  std::cout << "equations hold " << (residual < 1e-10 * scale)
            << ", product is the matrix's " << (of_matrix < 1e-12 * scale)
            << ", prescribed " << velocity[3] * skew << " " << velocity[5][0]
            << " " << velocity[5][1] << ", reaction there "
            << ((momentum[5] - image[5]).norm() > 1e-3 * scale) << std::endl;
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>(JitteredBox<2>(4));
  test<3>(JitteredBox<3>(4));
  test<2>(BoxMesh<2>("hypercubes", 8));
  test<3>(BoxMesh<3>("hypercubes", 6));
}
