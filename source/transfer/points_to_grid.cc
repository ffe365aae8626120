#include <mpm_granular/transfer/points_to_grid.h>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  namespace
  {
    /**
     * Sums contributions of the points of a block by cell: points that are in
     * the same cell as the one before add to local sums, which go to the cell
     * when it changes.
     *
     * @tparam Sums what is summed for a cell.
     * @param contribute contribute(p, sums) adds point p.
     * @param store store(cell, sums) adds the sums to the cell's.
     */
    template <class Sums, int dim, class Contribute, class Store>
    void
    sum_by_cell(const Points::PointArrays<dim> &points,
                const PointBlock<dim>          &block,
                Contribute                    &&contribute,
                Store                         &&store)
    {
      for (const auto &run : block.runs)
        {
          Sums         sums{};
          unsigned int current = points.cell[run.begin];
          for (unsigned int p = run.begin; p < run.end; ++p)
            {
              if (points.cell[p] != current)
                {
                  store(current, sums);
                  sums    = Sums{};
                  current = points.cell[p];
                }
              contribute(p, sums);
            }
          store(current, sums);
        }
    }

    template <int dim>
    struct MassAndMomentum
    {
      double mass[(dim + 1) * (dim + 1)];
      double momentum[dim][dim + 1];
    };
  } // namespace

  template <int dim>
  void
  add_mass_and_momentum(const Points::PointArrays<dim> &points,
                        const PointBlock<dim>          &block,
                        Grid::NodalFields<dim>         &fields)
  {
    // The inner loops run over the nodes of the cell: four of them fill a SIMD
    // register, whatever the length of the run.
    sum_by_cell<MassAndMomentum<dim>>(
      points,
      block,
      [&](const unsigned int p, MassAndMomentum<dim> &sums) {
        double shape_value[dim + 1], weighted[dim + 1];
        for (unsigned int k = 0; k <= dim; ++k)
          {
            shape_value[k] = block.shape_values[k][p - block.begin];
            weighted[k]    = points.mass[p] * shape_value[k];
          }
        for (unsigned int i = 0; i <= dim; ++i)
          for (unsigned int j = 0; j <= dim; ++j)
            sums.mass[i * (dim + 1) + j] += weighted[i] * shape_value[j];
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int k = 0; k <= dim; ++k)
            sums.momentum[d][k] += points.velocity[d][p] * weighted[k];
      },
      [&](const unsigned int cell, const MassAndMomentum<dim> &sums) {
        if (cell == Mesh::no_cell)
          return;
        Grid::CellSums<dim> &total = fields.sums_of(cell);
        for (unsigned int i = 0; i < (dim + 1) * (dim + 1); ++i)
          total.mass[i] += sums.mass[i];
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int k = 0; k <= dim; ++k)
            total.momentum[d][k] += sums.momentum[d][k];
      });
  }

  template <int dim>
  void
  add_stress(const Points::PointArrays<dim> &points,
             const PointBlock<dim>          &block,
             Grid::NodalFields<dim>         &fields)
  {
    sum_by_cell<Stress<dim>>(
      points,
      block,
      [&](const unsigned int p, Stress<dim> &sums) {
        for (unsigned int s = 0; s < n_stress<dim>; ++s)
          sums[s] += points.volume[p] * points.stress[s][p];
      },
      [&](const unsigned int cell, const Stress<dim> &sums) {
        if (cell == Mesh::no_cell)
          return;
        Stress<dim> &total = fields.sums_of(cell).stress;
        for (unsigned int s = 0; s < n_stress<dim>; ++s)
          total[s] += sums[s];
      });
  }

#define INSTANTIATE(dim)                                                \
  template void add_mass_and_momentum(const Points::PointArrays<dim> &, \
                                      const PointBlock<dim> &,          \
                                      Grid::NodalFields<dim> &);        \
  template void add_stress(const Points::PointArrays<dim> &,            \
                           const PointBlock<dim> &,                     \
                           Grid::NodalFields<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace mpm_granular::Transfer
