#include <deal.II/base/quadrature_lib.h>

#include <mpm_granular/points/cell_pattern.h>
#include <mpm_granular/points/symmetric.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

namespace mpm_granular::Points
{
  using namespace dealii;

  namespace
  {
    /// Barycentric coordinates of points that share a simplex equally.
    template <int dim>
    using Layout = std::vector<std::array<double, dim + 1>>;

    /// Shape values of points that share a cell equally.
    using ShapeValues = std::vector<std::vector<double>>;

    /// Numbers of points there are layouts for.
    template <int dim>
    std::vector<unsigned int>
    valid_numbers(const Mesh::SimplexCell<dim> &)
    {
      return dim == 2 ? std::vector<unsigned int>{1, 3, 4, 9, 16} :
                        std::vector<unsigned int>{1, 4, 8, 16};
    }

    template <int dim>
    std::vector<unsigned int>
    valid_numbers(const Mesh::BoxCell<dim> &)
    {
      return dim == 2 ? std::vector<unsigned int>{1, 4, 9, 16} :
                        std::vector<unsigned int>{1, 8, 27, 64};
    }

    /// Centroids of the n*n equal triangles that n cuts per edge make.
    Layout<2>
    triangle_centroids(const unsigned int n)
    {
      Layout<2>  layout;
      const auto add = [&](const double i, const double j) {
        layout.push_back({{1. - (i + j) / n, i / n, j / n}});
      };
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; i + j < n; ++j)
          {
            add(i + 1. / 3., j + 1. / 3.);
            if (i + j + 1 < n)
              add(i + 2. / 3., j + 2. / 3.);
          }
      return layout;
    }

    /// All distinct permutations of a set of coordinates.
    template <int dim>
    void
    add_orbit(Layout<dim> &layout, std::array<double, dim + 1> coordinates)
    {
      std::sort(coordinates.begin(), coordinates.end());
      do
        layout.push_back(coordinates);
      while (std::next_permutation(coordinates.begin(), coordinates.end()));
    }

    // Layouts of equal weights integrate quadratic functions exactly if the
    // mean of sum_i (lambda_i - 1/(dim+1))^2 over the points is that of the
    // simplex, 1/6 in a triangle and 3/20 in a tetrahedron; those below do,
    // except single points and the centroids of parts.

    Layout<2>
    layout_of(const unsigned int n_points, std::integral_constant<int, 2>)
    {
      if (n_points != 3)
        return triangle_centroids(std::lround(std::sqrt(n_points)));
      Layout<2> layout;
      add_orbit<2>(layout, {{2. / 3., 1. / 6., 1. / 6.}});
      return layout;
    }

    Layout<3>
    layout_of(const unsigned int n_points, std::integral_constant<int, 3>)
    {
      /// The orbit of a point on the line from the centroid to a vertex, at the
      /// distance that gives it this mean square.
      const auto corners = [](const double mean_square, const double sign) {
        const double first = .25 + sign * std::sqrt(.75 * mean_square);
        const double other = (1. - first) / 3.;
        return std::array<double, 4>{{first, other, other, other}};
      };
      Layout<3> layout;
      switch (n_points)
        {
          case 1:
            layout.push_back({{.25, .25, .25, .25}});
            break;
          case 4:
            add_orbit<3>(layout, corners(.15, 1.));
            break;
          case 8:
            add_orbit<3>(layout, corners(.25, 1.));
            add_orbit<3>(layout, corners(.05, -1.));
            break;
          default: // 16
            add_orbit<3>(layout, corners(.195, 1.));
            add_orbit<3>(layout, {{.55, .25, .1, .1}});
        }
      return layout;
    }

    template <int dim>
    ShapeValues
    shape_values(const Mesh::SimplexCell<dim> &, const unsigned int n_points)
    {
      ShapeValues result;
      for (const auto &values :
           layout_of(n_points, std::integral_constant<int, dim>()))
        result.emplace_back(values.begin(), values.end());
      return result;
    }

    /// Centres of equal parts.
    template <int dim>
    ShapeValues
    shape_values(const Mesh::BoxCell<dim> &, const unsigned int n_points)
    {
      const QIterated<dim> parts(QMidpoint<1>(),
                                 std::lround(std::pow(n_points, 1. / dim)));
      ShapeValues          result;
      for (const auto &place : parts.get_points())
        {
          std::array<double, dim> xi;
          for (unsigned int d = 0; d < dim; ++d)
            xi[d] = place[d];
          const auto values = Mesh::BoxCell<dim>::values_at(xi);
          result.emplace_back(values.begin(), values.end());
        }
      return result;
    }
  } // namespace

  template <int dim>
  void
  Symmetric<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Points per cell",
      points_per_cell,
      "Number of points in each cell: 1, 3, 4, 9 or 16 in a triangle, 1, 4, 8 "
      "or 16 in a tetrahedron, where fewer than 4 lose volume in flow; 1, 4, 9 "
      "or 16 in a quadrilateral, 1, 8, 27 or 64 in a hexahedron.",
      Patterns::Integer(1));
  }

  template <int dim>
  std::vector<Seed<dim>>
  Symmetric<dim>::seeds(const Mesh::BackgroundMesh<dim> &mesh,
                        const RegionShape<dim>          &shape,
                        const std::string & /*input_file*/) const
  {
    CellPattern pattern;
    mesh.visit([&](const auto &cells) {
      const typename std::decay_t<decltype(cells)>::value_type kind{};
      check_points_per_cell(points_per_cell, valid_numbers(kind), mesh);
      for (auto &values : shape_values(kind, points_per_cell))
        pattern.places.push_back({std::move(values), 1. / points_per_cell});
    });
    return repeat(pattern, mesh, shape);
  }

  template class Symmetric<2>;
  template class Symmetric<3>;

  namespace
  {
    const std::string documentation =
      "the same symmetric points in every simplex.";
    const PointLayoutRegistry<2>::Entry<Symmetric<2>>
      symmetric_2d("symmetric", documentation);
    const PointLayoutRegistry<3>::Entry<Symmetric<3>>
      symmetric_3d("symmetric", documentation);
  } // namespace
} // namespace mpm_granular::Points
