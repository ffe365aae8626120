#include <mpm_granular/points/symmetric.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

namespace mpm_granular::Points
{
  using namespace dealii;

  namespace
  {
    /// Barycentric coordinates of points that share a simplex equally.
    template <int dim>
    using Layout = std::vector<std::array<double, dim + 1>>;

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
  } // namespace

  template <int dim>
  void
  Symmetric<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Points per cell",
      points_per_cell,
      "Number of points in each simplex: 1, 3, 4, 9 or 16 in a triangle, 1, 4, 8 "
      "or 16 in a tetrahedron. Fewer than 4 lose volume in flow.",
      Patterns::Integer(1));
  }

  template <int dim>
  void
  Symmetric<dim>::check() const
  {
    const std::vector<unsigned int> valid =
      dim == 2 ? std::vector<unsigned int>{1, 3, 4, 9, 16} :
                 std::vector<unsigned int>{1, 4, 8, 16};
    require(std::find(valid.begin(), valid.end(), points_per_cell) !=
              valid.end(),
            std::string("'Points per cell' must be one of ") +
              (dim == 2 ? "1, 3, 4, 9, 16 in a triangle" :
                          "1, 4, 8, 16 in a tetrahedron") +
              "; given: " + std::to_string(points_per_cell) + ".");
  }

  template <int dim>
  std::vector<Seed<dim>>
  Symmetric<dim>::seeds(const Mesh::BackgroundMesh<dim> &mesh,
                        const RegionShape<dim>          &shape,
                        const std::string & /*input_file*/) const
  {
    const Layout<dim> layout =
      layout_of(points_per_cell, std::integral_constant<int, dim>());

    std::vector<Seed<dim>> seeds;
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      for (const auto &coordinates : layout)
        {
          Point<dim> x;
          for (unsigned int k = 0; k <= dim; ++k)
            x += coordinates[k] * mesh.node_position(mesh.cell(cell).node[k]);
          if (shape.contains(x, cell))
            seeds.push_back({x, cell, mesh.cell_volume(cell) / layout.size()});
        }
    return seeds;
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
