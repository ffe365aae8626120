#include <mpm_granular/transfer/points_to_grid.h>
#include <mpm_granular/transfer/sum_by_cell.h>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  namespace
  {
    template <class Cell>
    struct MassAndMomentum
    {
      Grid::CellMass<Cell> mass;
      double               momentum[Cell::dim][Cell::n_nodes];
    };

    /// Adds V sigma of a point.
    template <int dim>
    inline void
    add_stress(const Mesh::SimplexCell<dim> &,
               const Points::PointArrays<dim>           &points,
               const unsigned int                        p,
               Grid::StressSums<Mesh::SimplexCell<dim>> &sums)
    {
      for (unsigned int s = 0; s < n_stress<dim>; ++s)
        sums.stress[s] += points.volume[p] * points.stress[s][p];
    }

    /// Adds the forces of a point.
    template <int dim>
    inline void
    add_stress(const Mesh::BoxCell<dim>             &cell,
               const Points::PointArrays<dim>       &points,
               const unsigned int                    p,
               Grid::StressSums<Mesh::BoxCell<dim>> &sums)
    {
      using Cell = Mesh::BoxCell<dim>;
      double sigma[dim][dim];
      for (unsigned int s = 0; s < n_stress<dim>; ++s)
        {
          const unsigned int i = stress_index[s][0], j = stress_index[s][1];
          if (i < dim && j < dim)
            sigma[i][j] = sigma[j][i] = points.volume[p] * points.stress[s][p];
        }
      double flux[dim][dim]; // V sigma . g_d
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int d = 0; d < dim; ++d)
          {
            flux[i][d] = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              flux[i][d] += sigma[i][j] * cell.gradient[d][j];
          }
      const auto derivatives =
        Cell::derivatives_at(cell.unit_coordinates(points.location(p)));
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int k = 0; k < Cell::n_nodes; ++k)
            sums.force[i][k] -= flux[i][d] * derivatives[d][k];
    }
  } // namespace

  template <int dim>
  void
  add_mass_and_momentum(const Mesh::BackgroundMesh<dim> &mesh,
                        const Points::PointArrays<dim>  &points,
                        const PointBlock<dim>           &block,
                        Grid::NodalFields<dim>          &fields)
  {
    // The inner loops run over the nodes of the cell: four of them fill a SIMD
    // register, whatever the length of the run.
    mesh.visit([&](const auto &cells) {
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      constexpr unsigned int n_nodes = Cell::n_nodes;
      auto                  &active  = fields.template cells<Cell>();
      sum_by_cell<MassAndMomentum<Cell>>(
        points,
        block,
        [&](const unsigned int p, MassAndMomentum<Cell> &sums) {
          double shape_value[n_nodes], weighted[n_nodes];
          for (unsigned int k = 0; k < n_nodes; ++k)
            {
              shape_value[k] = block.shape_values[k][p - block.begin];
              weighted[k]    = points.mass[p] * shape_value[k];
            }
          sums.mass.add(shape_value, weighted);
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int k = 0; k < n_nodes; ++k)
              sums.momentum[d][k] += points.velocity[d][p] * weighted[k];
        },
        [&](const unsigned int cell, const MassAndMomentum<Cell> &sums) {
          if (cell == Mesh::no_cell)
            return;
          Grid::CellSums<Cell> &total = fields.sums_of(active, cell);
          total.mass += sums.mass;
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int k = 0; k < n_nodes; ++k)
              total.momentum[d][k] += sums.momentum[d][k];
        });
    });
  }

  template <int dim>
  void
  add_stress(const Mesh::BackgroundMesh<dim> &mesh,
             const Points::PointArrays<dim>  &points,
             const PointBlock<dim>           &block,
             Grid::NodalFields<dim>          &fields)
  {
    mesh.visit([&](const auto &cells) {
      using Cell   = typename std::decay_t<decltype(cells)>::value_type;
      using Sums   = Grid::StressSums<Cell>;
      auto &active = fields.template cells<Cell>();
      sum_by_cell<Sums>(
        points,
        block,
        [&](const unsigned int p, Sums &sums) {
          if (points.cell[p] != Mesh::no_cell)
            add_stress(cells[points.cell[p]], points, p, sums);
        },
        [&](const unsigned int cell, const Sums &sums) {
          if (cell == Mesh::no_cell)
            return;
          fields.sums_of(active, cell).internal += sums;
        });
    });
  }

#define INSTANTIATE(dim)                                                 \
  template void add_mass_and_momentum(const Mesh::BackgroundMesh<dim> &, \
                                      const Points::PointArrays<dim> &,  \
                                      const PointBlock<dim> &,           \
                                      Grid::NodalFields<dim> &);         \
  template void add_stress(const Mesh::BackgroundMesh<dim> &,            \
                           const Points::PointArrays<dim> &,             \
                           const PointBlock<dim> &,                      \
                           Grid::NodalFields<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace mpm_granular::Transfer
