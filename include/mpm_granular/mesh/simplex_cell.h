#ifndef mpm_granular_mesh_simplex_cell_h
#define mpm_granular_mesh_simplex_cell_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>

namespace mpm_granular::Mesh
{
  /**
   * All that the time step needs of a simplex, in one compact block (two cache
   * lines in 3D): the affine shape functions N_k(x) = g_k . (x - x_0), k =
   * 1..dim, N_0 = 1 - sum of the others, its nodes and its neighbours.
   */
  template <int dim_>
  struct alignas(32) SimplexCell
  {
    static constexpr int          dim     = dim_;
    static constexpr unsigned int n_nodes = dim + 1;
    static constexpr unsigned int n_faces = dim + 1;

    /// Volume of the reference cell: this is the part of a box it fills.
    static constexpr double reference_volume = dim == 2 ? 1. / 2. : 1. / 6.;

    /// Volume over that of a prism with the same height above the same face.
    static constexpr double cone_volume = 1. / dim;

    /// The vertex at the end of edge @p d of those that leave vertex 0.
    static constexpr unsigned int
    end_of_edge(const unsigned int d)
    {
      return d + 1;
    }

    /// Whether vertex @p k lies on face @p f, the one opposite to vertex f.
    static constexpr bool
    is_on_face(const unsigned int k, const unsigned int f)
    {
      return k != f;
    }

    std::array<double, dim>                  origin;   ///< vertex 0, x_0 [m]
    std::array<std::array<double, dim>, dim> gradient; ///< g_1 .. g_dim [1/m]
    std::array<unsigned int, n_nodes>        node;     ///< by vertex
    std::array<unsigned int, n_faces> neighbor; ///< cell opposite to node k

    /// Values of the shape functions (barycentric coordinates) at @p x.
    std::array<double, n_nodes>
    shape_values(const dealii::Point<dim> &x) const
    {
      std::array<double, n_nodes> values;
      values[0] = 1.;
      for (unsigned int k = 0; k < dim; ++k)
        {
          values[k + 1] = 0.;
          for (unsigned int d = 0; d < dim; ++d)
            values[k + 1] += gradient[k][d] * (x[d] - origin[d]);
          values[0] -= values[k + 1];
        }
      return values;
    }

    /// The same, with @p x moved to where it is at least @p least inside.
    std::array<double, n_nodes>
    inner_shape_values(const dealii::Point<dim> &x, const double least) const
    {
      auto   values = shape_values(x);
      double sum    = 0.;
      for (double &value : values)
        sum += value = std::max(value, least);
      for (double &value : values)
        value /= sum;
      return values;
    }

    /// How far @p x is from each face, in heights of the cell above that face;
    /// negative outside.
    std::array<double, n_faces>
    heights(const dealii::Point<dim> &x) const
    {
      return shape_values(x);
    }

    /// Where @p x is in deal.II's reference cell.
    dealii::Point<dim>
    reference_point(const dealii::Point<dim> &x) const
    {
      const auto         values = shape_values(x);
      dealii::Point<dim> point;
      for (unsigned int d = 0; d < dim; ++d)
        point[d] = values[d + 1];
      return point;
    }

    /// Gradient of the height above face @p f.
    dealii::Tensor<1, dim>
    inward(const unsigned int f) const
    {
      return shape_gradient(f);
    }

    /// Gradient of shape function @p k, 0..dim.
    dealii::Tensor<1, dim>
    shape_gradient(const unsigned int k) const
    {
      dealii::Tensor<1, dim> g;
      for (unsigned int d = 0; d < dim; ++d)
        if (k > 0)
          g[d] = gradient[k - 1][d];
        else
          for (unsigned int j = 0; j < dim; ++j)
            g[d] -= gradient[j][d];
      return g;
    }

    /// The same gradients, at the centre as everywhere.
    dealii::Tensor<1, dim>
    central_gradient(const unsigned int k) const
    {
      return shape_gradient(k);
    }
  };
} // namespace mpm_granular::Mesh

#endif
