#ifndef mpm_granular_mesh_simplex_cell_h
#define mpm_granular_mesh_simplex_cell_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <array>

namespace mpm_granular::Mesh
{
  /// Stands for "no cell": what lies beyond a boundary face.
  inline constexpr unsigned int no_cell = dealii::numbers::invalid_unsigned_int;

  /**
   * All that the time step needs of a simplex, in one compact block (two cache
   * lines in 3D): the affine shape functions N_k(x) = g_k . (x - x_0), k =
   * 1..dim, N_0 = 1 - sum of the others, its nodes and its neighbours.
   */
  template <int dim>
  struct alignas(32) SimplexCell
  {
    static constexpr unsigned int n_nodes = dim + 1;

    std::array<double, dim>                  origin;   ///< vertex 0, x_0 [m]
    std::array<std::array<double, dim>, dim> gradient; ///< g_1 .. g_dim [1/m]
    std::array<unsigned int, n_nodes>        node;     ///< DoF indices
    std::array<unsigned int, n_nodes> neighbor; ///< cell opposite to node k

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
  };
} // namespace mpm_granular::Mesh

#endif
