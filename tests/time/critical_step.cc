// The stability limit against the closed forms of theory.md (T24): equilateral
// triangle omega^2 = (6/h^2) 2 (K + G/3)/rho, regular tetrahedron omega^2 =
// (8/h^2) 3K/rho, h the edge; and it is proportional to h.

#include <deal.II/base/point.h>

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
