#ifndef mpm_granular_grid_cell_sums_h
#define mpm_granular_grid_cell_sums_h

#include <mpm_granular/core/stress_layout.h>
#include <mpm_granular/mesh/box_cell.h>
#include <mpm_granular/mesh/simplex_cell.h>

#include <array>

namespace mpm_granular::Grid
{
  /// The consistent mass matrix of a cell, M_ij = sum_p m_p N_i N_j [kg].
  template <class Cell>
  struct CellMass;

  /// Of a simplex, in full storage.
  template <int dim>
  struct CellMass<Mesh::SimplexCell<dim>>
  {
    static constexpr unsigned int n_nodes = dim + 1;

    std::array<double, n_nodes * n_nodes> entries;

    double
    operator()(const unsigned int i, const unsigned int j) const
    {
      return entries[i * n_nodes + j];
    }

    /// Adds a point.
    /// @param weighted its mass times the shape values.
    void
    add(const double (&shape_values)[n_nodes],
        const double (&weighted)[n_nodes])
    {
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int j = 0; j < n_nodes; ++j)
          entries[i * n_nodes + j] += weighted[i] * shape_values[j];
    }

    void
    operator+=(const CellMass &other)
    {
      for (unsigned int i = 0; i < entries.size(); ++i)
        entries[i] += other.entries[i];
    }
  };

  /**
   * Of a box. N_i N_j is a product over the directions of (1 - xi)^2, xi (1 -
   * xi) or xi^2, according to how many of the two vertices lie at xi = 1: all
   * entries are among 3^dim numbers, and M_ij is number place(i) + place(j).
   */
  template <int dim>
  struct CellMass<Mesh::BoxCell<dim>>
  {
    using Cell                              = Mesh::BoxCell<dim>;
    static constexpr unsigned int n_nodes   = Cell::n_nodes;
    static constexpr unsigned int n_numbers = dim == 2 ? 9 : 27;

    std::array<double, n_numbers> entries;

    static constexpr unsigned int
    place(const unsigned int i)
    {
      return i % 2 + 3 * (i / 2 % 2) + 9 * (i / 4);
    }

    double
    operator()(const unsigned int i, const unsigned int j) const
    {
      return entries[place(i) + place(j)];
    }

    /// Adds a point.
    /// @param weighted its mass times the shape values.
    void
    add(const double (&shape_values)[n_nodes],
        const double (&weighted)[n_nodes])
    {
      double mass = 0.;
      for (const double part : weighted)
        mass += part;
      double factor[dim][3];
      for (unsigned int d = 0; d < dim; ++d)
        {
          double xi = 0.;
          for (unsigned int k = 0; k < n_nodes; ++k)
            if (Cell::is_upper(k, d))
              xi += shape_values[k];
          factor[d][0] = (1. - xi) * (1. - xi);
          factor[d][1] = xi * (1. - xi);
          factor[d][2] = xi * xi;
        }
      for (unsigned int c = 0; c < n_numbers / 9; ++c)
        for (unsigned int b = 0; b < 3; ++b)
          {
            const double product =
              mass * factor[1][b] * (dim == 3 ? factor[dim - 1][c] : 1.);
            for (unsigned int a = 0; a < 3; ++a)
              entries[9 * c + 3 * b + a] += product * factor[0][a];
          }
    }

    void
    operator+=(const CellMass &other)
    {
      for (unsigned int i = 0; i < n_numbers; ++i)
        entries[i] += other.entries[i];
    }
  };

  /// What the internal forces of the nodes of a cell follow from, summed over
  /// its points (T9).
  template <class Cell>
  struct StressSums;

  /// In a simplex gradients are constant: -stress . grad N_i is the force on
  /// node i.
  template <int dim>
  struct StressSums<Mesh::SimplexCell<dim>>
  {
    /// sum_p V_p sigma_p [J].
    Stress<dim> stress;

    void
    operator+=(const StressSums &other)
    {
      for (unsigned int s = 0; s < n_stress<dim>; ++s)
        stress[s] += other.stress[s];
    }

    void
    operator*=(const double factor)
    {
      for (double &component : stress)
        component *= factor;
    }
  };

  /// In a box gradients depend on the place, so that forces are summed.
  template <int dim>
  struct StressSums<Mesh::BoxCell<dim>>
  {
    /// -sum_p V_p sigma_p . grad N_i(x_p), components first [N].
    std::array<std::array<double, Mesh::BoxCell<dim>::n_nodes>, dim> force;

    void
    operator+=(const StressSums &other)
    {
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int k = 0; k < force[d].size(); ++k)
          force[d][k] += other.force[d][k];
    }

    void
    operator*=(const double factor)
    {
      for (auto &component : force)
        for (double &value : component)
          value *= factor;
    }
  };

  /**
   * What the points of a cell contribute to the grid, summed over the points
   * (T9). Nodal values follow from it: masses are the row sums of the mass
   * matrix.
   */
  template <class Cell>
  struct CellSums
  {
    static constexpr unsigned int n_nodes = Cell::n_nodes;

    CellMass<Cell> mass;

    /// Momentum sum_p m_p N_i v_p, components first [kg m/s].
    std::array<std::array<double, n_nodes>, Cell::dim> momentum;

    StressSums<Cell> internal;
  };
} // namespace mpm_granular::Grid

#endif
