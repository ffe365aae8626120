#ifndef mpm_granular_mesh_box_cell_h
#define mpm_granular_mesh_box_cell_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>

namespace mpm_granular::Mesh
{
  /**
   * All that the time step needs of a box-like cell (a parallelogram, a
   * parallelepiped), in one compact block: the affine map to the unit cube,
   * xi_d = g_d . (x - x_0), its nodes and its neighbours, numbered as deal.II
   * numbers vertices and faces. The shape functions are products of xi_d and
   * 1 - xi_d.
   */
  template <int dim_>
  struct alignas(32) BoxCell
  {
    static constexpr int          dim     = dim_;
    static constexpr unsigned int n_nodes = 1u << dim;
    static constexpr unsigned int n_faces = 2 * dim;

    /// Volume of the reference cell.
    static constexpr double reference_volume = 1.;

    /// Volume over that of a prism with the same height above the same face.
    static constexpr double cone_volume = 1.;

    /// The vertex at the end of edge @p d of those that leave vertex 0.
    static constexpr unsigned int
    end_of_edge(const unsigned int d)
    {
      return 1u << d;
    }

    /// Whether vertex @p k lies at xi_d = 1 and not at 0.
    static constexpr bool
    is_upper(const unsigned int k, const unsigned int d)
    {
      return (k >> d) % 2 == 1;
    }

    /// Whether vertex @p k lies on face @p f.
    static constexpr bool
    is_on_face(const unsigned int k, const unsigned int f)
    {
      return is_upper(k, f / 2) == (f % 2 == 1);
    }

    std::array<double, dim>                  origin;   ///< vertex 0, x_0 [m]
    std::array<std::array<double, dim>, dim> gradient; ///< g_1 .. g_dim [1/m]
    std::array<unsigned int, n_nodes>        node;     ///< by vertex
    std::array<unsigned int, n_faces>        neighbor; ///< cell behind face f

    /// Where @p x is in the unit cube.
    template <class Number>
    std::array<Number, dim>
    unit_coordinates(const std::array<Number, dim> &x) const
    {
      std::array<Number, dim> xi;
      for (unsigned int d = 0; d < dim; ++d)
        {
          xi[d] = gradient[d][0] * (x[0] - origin[0]);
          for (unsigned int j = 1; j < dim; ++j)
            xi[d] += gradient[d][j] * (x[j] - origin[j]);
        }
      return xi;
    }

    std::array<double, dim>
    unit_coordinates(const dealii::Point<dim> &x) const
    {
      std::array<double, dim> components;
      for (unsigned int d = 0; d < dim; ++d)
        components[d] = x[d];
      return unit_coordinates(components);
    }

    /// Values of the shape functions at a place of the unit cube, products of
    /// xi_d and 1 - xi_d; each direction doubles their number.
    template <class Number>
    static std::array<Number, n_nodes>
    values_at(const std::array<Number, dim> &xi)
    {
      std::array<Number, n_nodes> values;
      values[0] = 1.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const Number       rest = 1. - xi[d];
          const unsigned int half = 1u << d;
          for (unsigned int k = 0; k < half; ++k)
            {
              values[k + half] = values[k] * xi[d];
              values[k]        = values[k] * rest;
            }
        }
      return values;
    }

    /// Derivatives of the shape functions with respect to xi_1 .. xi_dim at a
    /// place of the unit cube.
    static std::array<std::array<double, n_nodes>, dim>
    derivatives_at(const std::array<double, dim> &xi)
    {
      std::array<std::array<double, n_nodes>, dim> derivatives;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int k = 0; k < n_nodes; ++k)
          {
            double product = is_upper(k, d) ? 1. : -1.;
            for (unsigned int e = 0; e < dim; ++e)
              if (e != d)
                product *= is_upper(k, e) ? xi[e] : 1. - xi[e];
            derivatives[d][k] = product;
          }
      return derivatives;
    }

    /// Values of the shape functions at @p x.
    std::array<double, n_nodes>
    shape_values(const dealii::Point<dim> &x) const
    {
      return values_at(unit_coordinates(x));
    }

    /// The same, with @p x moved to where it is at least @p least inside.
    std::array<double, n_nodes>
    inner_shape_values(const dealii::Point<dim> &x, const double least) const
    {
      auto xi = unit_coordinates(x);
      for (double &coordinate : xi)
        coordinate = std::min(std::max(coordinate, least), 1. - least);
      return values_at(xi);
    }

    /// How far @p x is from each face, in heights of the cell above that face;
    /// negative outside.
    std::array<double, n_faces>
    heights(const dealii::Point<dim> &x) const
    {
      const auto                  xi = unit_coordinates(x);
      std::array<double, n_faces> result;
      for (unsigned int d = 0; d < dim; ++d)
        {
          result[2 * d]     = xi[d];
          result[2 * d + 1] = 1. - xi[d];
        }
      return result;
    }

    /// Where @p x is in deal.II's reference cell.
    dealii::Point<dim>
    reference_point(const dealii::Point<dim> &x) const
    {
      const auto         xi = unit_coordinates(x);
      dealii::Point<dim> point;
      for (unsigned int d = 0; d < dim; ++d)
        point[d] = xi[d];
      return point;
    }

    /// Gradient of the height above face @p f.
    dealii::Tensor<1, dim>
    inward(const unsigned int f) const
    {
      dealii::Tensor<1, dim> g;
      for (unsigned int j = 0; j < dim; ++j)
        g[j] = (f % 2 == 0 ? 1. : -1.) * gradient[f / 2][j];
      return g;
    }

    /// Gradient of shape function @p k at a place of the unit cube.
    dealii::Tensor<1, dim>
    shape_gradient(const std::array<double, dim> &xi,
                   const unsigned int             k) const
    {
      const auto             derivatives = derivatives_at(xi);
      dealii::Tensor<1, dim> g;
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int j = 0; j < dim; ++j)
          g[j] += derivatives[d][k] * gradient[d][j];
      return g;
    }

    /// Gradient of shape function @p k at the centre.
    dealii::Tensor<1, dim>
    central_gradient(const unsigned int k) const
    {
      std::array<double, dim> center;
      center.fill(.5);
      return shape_gradient(center, k);
    }
  };
} // namespace mpm_granular::Mesh

#endif
