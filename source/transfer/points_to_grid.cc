#include <mpm_granular/core/lanes.h>
#include <mpm_granular/transfer/points_to_grid.h>
#include <mpm_granular/transfer/sum_by_cell.h>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  namespace
  {
    /// Mass and momentum of some points of a cell.
    template <class Cell>
    struct MassAndMomentum
    {
      static constexpr unsigned int n_nodes = Cell::n_nodes;

      Grid::CellMass<Cell> mass;
      double               momentum[Cell::dim][n_nodes];

      void
      add(const double                         of_point,
          const double                        *values,
          const std::array<double, Cell::dim> &velocity)
      {
        double shape_value[n_nodes], weighted[n_nodes];
        for (unsigned int k = 0; k < n_nodes; ++k)
          {
            shape_value[k] = values[k];
            weighted[k]    = of_point * values[k];
          }
        mass.add(shape_value, weighted);
        for (unsigned int d = 0; d < Cell::dim; ++d)
          for (unsigned int k = 0; k < n_nodes; ++k)
            momentum[d][k] += velocity[d] * weighted[k];
      }

      void
      add_to(Grid::CellSums<Cell> &total) const
      {
        total.mass += mass;
        for (unsigned int d = 0; d < Cell::dim; ++d)
          for (unsigned int k = 0; k < n_nodes; ++k)
            total.momentum[d][k] += momentum[d][k];
      }
    };

    /// Of a tetrahedron, with a lane for each node.
    template <>
    struct MassAndMomentum<Mesh::SimplexCell<3>>
    {
      Lanes mass[4], momentum[3];

      void
      add(const double                 of_point,
          const double                *values,
          const std::array<double, 3> &velocity)
      {
        const Lanes weighted = load<Lanes>(values) * of_point;
        for (unsigned int i = 0; i < 4; ++i)
          mass[i] += weighted * values[i];
        for (unsigned int d = 0; d < 3; ++d)
          momentum[d] += weighted * velocity[d];
      }

      void
      add_to(Grid::CellSums<Mesh::SimplexCell<3>> &total) const
      {
        const auto add = [](const Lanes &sum, double *to) {
          store(load<Lanes>(to) + sum, to);
        };
        for (unsigned int i = 0; i < 4; ++i)
          add(mass[i], &total.mass.entries[4 * i]);
        for (unsigned int d = 0; d < 3; ++d)
          add(momentum[d], total.momentum[d].data());
      }
    };

    /// The stresses and volumes of the points, as raw pointers: loops that also
    /// write to memory would read the vectors' pointers again and again.
    template <int dim>
    struct StressesOfPoints
    {
      StressesOfPoints(const Points::PointArrays<dim> &points)
        : volume(points.volume.data())
      {
        for (unsigned int s = 0; s < n_stress<dim>; ++s)
          stress[s] = points.stress[s].data();
      }

      const double                             *volume;
      std::array<const double *, n_stress<dim>> stress;
    };

    /// Adds V sigma of points in sequence: four points at a time, then their
    /// sum; of the last four only those that belong to them.
    template <int dim>
    inline void
    add_stress(const Mesh::SimplexCell<dim> &,
               const Points::PointArrays<dim>           &points,
               const StressesOfPoints<dim>              &of_points,
               const Points::Run                         range,
               Grid::StressSums<Mesh::SimplexCell<dim>> &sums)
    {
      for (unsigned int p = range.begin; p < range.end; p += Lanes::n)
        if (p + Lanes::n <= points.size())
          {
            const Lanes volume =
              first_of(load<Lanes>(of_points.volume + p), range.end - p);
            for (unsigned int s = 0; s < n_stress<dim>; ++s)
              sums.stress[s] +=
                sum(volume * load<Lanes>(of_points.stress[s] + p));
          }
        else
          for (unsigned int q = p; q < range.end; ++q)
            for (unsigned int s = 0; s < n_stress<dim>; ++s)
              sums.stress[s] += of_points.volume[q] * of_points.stress[s][q];
    }

    /// Adds the forces of a point.
    template <int dim>
    inline void
    add_force(const Mesh::BoxCell<dim>             &cell,
              const Points::PointArrays<dim>       &points,
              const StressesOfPoints<dim>          &of_points,
              const unsigned int                    p,
              Grid::StressSums<Mesh::BoxCell<dim>> &sums)
    {
      using Cell = Mesh::BoxCell<dim>;
      double sigma[dim][dim];
      for (unsigned int s = 0; s < n_stress<dim>; ++s)
        {
          const unsigned int i = stress_index[s][0], j = stress_index[s][1];
          if (i < dim && j < dim)
            sigma[i][j] = sigma[j][i] =
              of_points.volume[p] * of_points.stress[s][p];
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

    template <int dim>
    inline void
    add_stress(const Mesh::BoxCell<dim>             &cell,
               const Points::PointArrays<dim>       &points,
               const StressesOfPoints<dim>          &of_points,
               const Points::Run                     range,
               Grid::StressSums<Mesh::BoxCell<dim>> &sums)
    {
      for (unsigned int p = range.begin; p < range.end; ++p)
        add_force(cell, points, of_points, p, sums);
    }
  } // namespace

  template <int dim>
  void
  add_mass_and_momentum(const Mesh::BackgroundMesh<dim> &mesh,
                        const Points::PointArrays<dim>  &points,
                        PointBlock<dim>                 &block,
                        Grid::NodalFields<dim>          &fields)
  {
    // The inner loops run over the nodes of the cell: four of them fill a SIMD
    // register, whatever the length of the run.
    mesh.visit([&](const auto &cells) {
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      constexpr unsigned int n_nodes = Cell::n_nodes;
      auto                  &active  = fields.template cells<Cell>();
      block.template order_by_point<n_nodes>();
      const double *const             mass   = points.mass.data();
      const double *const             values = block.values_by_point.data();
      std::array<const double *, dim> velocity;
      for (unsigned int d = 0; d < dim; ++d)
        velocity[d] = points.velocity[d].data();
      sum_by_cell<MassAndMomentum<Cell>>(
        points,
        block,
        [=, begin = block.begin](const unsigned int     p,
                                 MassAndMomentum<Cell> &sums) {
          std::array<double, dim> of_point;
          for (unsigned int d = 0; d < dim; ++d)
            of_point[d] = velocity[d][p];
          sums.add(mass[p], values + (p - begin) * n_nodes, of_point);
        },
        [&](const unsigned int cell, const MassAndMomentum<Cell> &sums) {
          if (cell != Mesh::no_cell)
            sums.add_to(fields.sums_of(active, cell));
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
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      using Sums = Grid::StressSums<Cell>;
      auto                       &active = fields.template cells<Cell>();
      const StressesOfPoints<dim> of_points(points);
      for_each_in_same_cell(
        points, block, [&](const unsigned int cell, const Points::Run range) {
          if (cell == Mesh::no_cell)
            return;
          Sums sums{};
          add_stress(cells[cell], points, of_points, range, sums);
          fields.sums_of(active, cell).internal += sums;
        });
    });
  }

#define INSTANTIATE(dim)                                                 \
  template void add_mass_and_momentum(const Mesh::BackgroundMesh<dim> &, \
                                      const Points::PointArrays<dim> &,  \
                                      PointBlock<dim> &,                 \
                                      Grid::NodalFields<dim> &);         \
  template void add_stress(const Mesh::BackgroundMesh<dim> &,            \
                           const Points::PointArrays<dim> &,             \
                           const PointBlock<dim> &,                      \
                           Grid::NodalFields<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace mpm_granular::Transfer
