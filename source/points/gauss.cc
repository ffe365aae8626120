#include <deal.II/base/quadrature_lib.h>

#include <mpm_granular/points/cell_pattern.h>
#include <mpm_granular/points/gauss.h>

#include <array>
#include <vector>

namespace mpm_granular::Points
{
  using namespace dealii;

  template <int dim>
  void
  Gauss<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Points per cell",
      points_per_cell,
      "Number of points in each cell: 1, 4 or 9 in a "
      "quadrilateral, 1, 8 or 27 in a hexahedron. With three in "
      "each direction their masses differ.",
      Patterns::Integer(1));
  }

  template <int dim>
  std::vector<Seed<dim>>
  Gauss<dim>::seeds(const Mesh::BackgroundMesh<dim> &mesh,
                    const RegionShape<dim>          &shape,
                    const std::string & /*input_file*/) const
  {
    require(mesh.cell_kind() == Mesh::CellKind::hypercube,
            "The layout 'Gauss' of points is for hypercubes; in " +
              Mesh::name_of_cells(mesh.cell_kind(), dim) +
              ", 'symmetric' does as well.");
    CellPattern               pattern;
    std::vector<unsigned int> valid;
    for (unsigned int n = 1; n <= 3; ++n)
      {
        const QGauss<dim> points(n);
        valid.push_back(points.size());
        if (points.size() != points_per_cell)
          continue;
        for (unsigned int q = 0; q < points.size(); ++q)
          {
            std::array<double, dim> xi;
            for (unsigned int d = 0; d < dim; ++d)
              xi[d] = points.point(q)[d];
            const auto values = Mesh::BoxCell<dim>::values_at(xi);
            pattern.places.push_back(
              {{values.begin(), values.end()}, points.weight(q)});
          }
      }
    check_points_per_cell(points_per_cell, valid, mesh);
    return repeat(pattern, mesh, shape);
  }

  template class Gauss<2>;
  template class Gauss<3>;

  namespace
  {
    const std::string documentation =
      "the points of Gauss quadrature in every hypercube.";
    const PointLayoutRegistry<2>::Entry<Gauss<2>> gauss_2d("Gauss",
                                                           documentation);
    const PointLayoutRegistry<3>::Entry<Gauss<3>> gauss_3d("Gauss",
                                                           documentation);
  } // namespace
} // namespace mpm_granular::Points
