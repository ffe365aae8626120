#include <mpm_granular/points/symmetric.h>

#include <deal.II/base/quadrature_lib.h>

namespace mpm_granular::Points
{
  using namespace dealii;

  namespace
  {
    /// Centroids of the n*n equal triangles that n cuts per edge make.
    Quadrature<2>
    triangle_centroids(const unsigned int n)
    {
      std::vector<Point<2>> points;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; i + j < n; ++j)
          {
            points.emplace_back((i + 1. / 3.) / n, (j + 1. / 3.) / n);
            if (i + j + 1 < n)
              points.emplace_back((i + 2. / 3.) / n, (j + 2. / 3.) / n);
          }
      return {points, std::vector<double>(points.size(), .5 / points.size())};
    }

    /// Points on the unit simplex; weights add up to its volume.
    Quadrature<2>
    layout(const unsigned int n_points, const Quadrature<2> &)
    {
      switch (n_points)
        {
          case 3:
            return QGaussSimplex<2>(2);
          case 6:
            return QWitherdenVincentSimplex<2>(2);
          default:
            return triangle_centroids(n_points == 1 ? 1 :
                                      n_points == 4 ? 2 :
                                      n_points == 9 ? 3 :
                                                      4);
        }
    }

    Quadrature<3>
    layout(const unsigned int n_points, const Quadrature<3> &)
    {
      switch (n_points)
        {
          case 1:
            return QGaussSimplex<3>(1);
          case 4:
            return QGaussSimplex<3>(2);
          case 8:
            return QWitherdenVincentSimplex<3>(2);
          default:
            return QWitherdenVincentSimplex<3>(3);
        }
    }
  } // namespace

  template <int dim>
  void
  Symmetric<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Points per cell",
      points_per_cell,
      "Number of points in each simplex: 1, 3, 4, 6, 9 or 16 in a triangle, 1, "
      "4, 8 or 14 in a tetrahedron. Fewer than 4 lose volume in flow.",
      Patterns::Integer(1));
  }

  template <int dim>
  void
  Symmetric<dim>::check() const
  {
    const std::vector<unsigned int> valid =
      dim == 2 ? std::vector<unsigned int>{1, 3, 4, 6, 9, 16} :
                 std::vector<unsigned int>{1, 4, 8, 14};
    require(std::find(valid.begin(), valid.end(), points_per_cell) != valid.end(),
            std::string("'Points per cell' must be one of ") +
              (dim == 2 ? "1, 3, 4, 6, 9, 16 in a triangle" :
                          "1, 4, 8, 14 in a tetrahedron") +
              "; given: " + std::to_string(points_per_cell) + ".");
  }

  template <int dim>
  std::vector<Seed<dim>>
  Symmetric<dim>::seeds(const Mesh::BackgroundMesh<dim> &mesh,
                        const RegionShape<dim>          &shape,
                        const std::string & /*input_file*/) const
  {
    const Quadrature<dim> reference = layout(points_per_cell, Quadrature<dim>());
    double                total     = 0.;
    for (const double weight : reference.get_weights())
      total += weight;

    std::vector<Seed<dim>> seeds;
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      for (unsigned int q = 0; q < reference.size(); ++q)
        {
          // Barycentric coordinates of the reference point act on the vertices.
          Point<dim> x;
          double     first = 1.;
          for (unsigned int k = 0; k < dim; ++k)
            {
              x += reference.point(q)[k] *
                   mesh.node_position(mesh.cell(cell).node[k + 1]);
              first -= reference.point(q)[k];
            }
          x += first * mesh.node_position(mesh.cell(cell).node[0]);
          if (shape.contains(x, cell))
            seeds.push_back(
              {x, cell, mesh.cell_volume(cell) * reference.weight(q) / total});
        }
    return seeds;
  }

  template class Symmetric<2>;
  template class Symmetric<3>;

  namespace
  {
    const std::string documentation =
      "the same symmetric points in every simplex.";
    const PointLayoutRegistry<2>::Entry<Symmetric<2>> symmetric_2d("symmetric",
                                                                   documentation);
    const PointLayoutRegistry<3>::Entry<Symmetric<3>> symmetric_3d("symmetric",
                                                                   documentation);
  } // namespace
} // namespace mpm_granular::Points
