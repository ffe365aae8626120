// The stability limit against the closed forms of theory.md (T24): equilateral
// triangle omega^2 = (6/h^2) 2 (K + G/3)/rho, regular tetrahedron omega^2 =
// (8/h^2) 3K/rho, h the edge; and it is proportional to h. For boxes, against
// the largest eigenvalue of the stiffness matrix that deal.II makes of the
// cell.

#include <deal.II/base/point.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/lapack_full_matrix.h>

#include <mpm_granular/time/critical_step.h>

#include <cmath>
#include <iostream>
#include <vector>

using namespace dealii;
using namespace mpm_granular;

/// The simplex with these vertices; only what the limit depends on is set.
template <int dim>
Mesh::SimplexCell<dim>
simplex(const std::vector<Point<dim>> &vertices, const double size)
{
  Tensor<2, dim> edges;
  for (unsigned int k = 0; k < dim; ++k)
    edges[k] = size * (vertices[k + 1] - vertices[0]);
  const Tensor<2, dim>   inverse = invert(edges);
  Mesh::SimplexCell<dim> cell;
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int k = 0; k < dim; ++k)
      cell.gradient[k][d] = inverse[d][k];
  return cell;
}

/// The limit of the box with these edges over that of deal.II's stiffness
/// matrix.
template <int dim>
double
box_over_matrix(const Tensor<2, dim> &edges,
                const double          bulk,
                const double          shear,
                const double          density)
{
  using Cell = Mesh::BoxCell<dim>;
  Triangulation<dim> tria;
  GridGenerator::hyper_cube(tria);
  GridTools::transform(
    [&](const Point<dim> &xi) { return Point<dim>(transpose(edges) * xi); },
    tria);
  const FESystem<dim> fe(FE_Q<dim>(1), dim);
  FEValues<dim>       values(fe,
                       QGauss<dim>(2),
                       update_gradients | update_JxW_values);
  values.reinit(tria.begin_active());
  const unsigned int       n = fe.n_dofs_per_cell();
  LAPACKFullMatrix<double> matrix(n, n);
  double                   volume = 0.;
  for (const unsigned int q : values.quadrature_point_indices())
    {
      volume += values.JxW(q);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            const FEValuesExtractors::Vector displacement(0);
            const auto e_i = values[displacement].symmetric_gradient(i, q);
            const auto e_j = values[displacement].symmetric_gradient(j, q);
            matrix(i, j) += values.JxW(q) * ((bulk - 2. / 3. * shear) *
                                               trace(e_i) * trace(e_j) +
                                             2. * shear * (e_i * e_j));
          }
    }
  FullMatrix<double> vectors;
  Vector<double>     eigenvalues;
  matrix.compute_eigenvalues_symmetric(
    -1., 1e10 * bulk, 1e-10, eigenvalues, vectors);
  const double omega_squared =
    eigenvalues.linfty_norm() * Cell::n_nodes / (density * volume);

  const Tensor<2, dim> inverse = invert(edges);
  Cell                 cell;
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int k = 0; k < dim; ++k)
      cell.gradient[k][d] = inverse[d][k];
  return Time::critical_step(cell, {bulk, shear, density}) *
         std::sqrt(omega_squared) / 2.;
}

int
main()
{
  const double bulk = 1e6 / 1.2, shear = 1e6 / 2.6, density = 1500.;
  const double c_p    = std::sqrt((bulk + 4. / 3. * shear) / density);
  const double root_3 = std::sqrt(3.);

  const std::vector<Point<2>> triangle{{0., 0.}, {1., 0.}, {.5, root_3 / 2.}};
  const std::vector<Point<3>> tetrahedron{{0., 0., 0.},
                                          {1., 0., 0.},
                                          {.5, root_3 / 2., 0.},
                                          {.5,
                                           root_3 / 6.,
                                           std::sqrt(2. / 3.)}};
  for (const double h : {1., .05})
    {
      const double omega_2d =
        std::sqrt(12. / (h * h) * (bulk + shear / 3.) / density);
      const double omega_3d = std::sqrt(24. / (h * h) * bulk / density);
      std::cout << "triangle, over closed form: "
                << Time::critical_step(simplex<2>(triangle, h),
                                       {bulk, shear, density}) *
                     omega_2d / 2.
                << std::endl
                << "tetrahedron, over closed form: "
                << Time::critical_step(simplex<3>(tetrahedron, h),
                                       {bulk, shear, density}) *
                     omega_3d / 2.
                << std::endl;
    }

  Tensor<2, 2> square, skew_2d;
  Tensor<2, 3> cube, skew_3d;
  for (unsigned int d = 0; d < 3; ++d)
    {
      if (d < 2)
        {
          square[d][d]  = .05;
          skew_2d[d][d] = 1. + d;
        }
      cube[d][d]    = .05;
      skew_3d[d][d] = 1. + d;
    }
  skew_2d[0][1] = .5;
  skew_3d[0][1] = .5;
  skew_3d[1][2] = -.7;
  std::cout << "square, skew one, over matrix: "
            << box_over_matrix(square, bulk, shear, density) << ' '
            << box_over_matrix(skew_2d, bulk, shear, density) << std::endl
            << "cube, skew one, over matrix: "
            << box_over_matrix(cube, bulk, shear, density) << ' '
            << box_over_matrix(skew_3d, bulk, shear, density) << std::endl;

  // dt c_p/h of the right triangle, and the corner of a cube.
  std::cout.precision(3);
  std::cout
    << "right triangle "
    << Time::critical_step(simplex<2>({{0., 0.}, {1., 0.}, {0., 1.}}, 1.),
                           {bulk, shear, density}) *
         c_p
    << ", corner "
    << Time::critical_step(
         simplex<3>({{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}},
                    1.),
         {bulk, shear, density}) *
         c_p
    << std::endl;
}
