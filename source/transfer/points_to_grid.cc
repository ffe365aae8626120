#include <mpm_granular/core/lanes.h>
#include <mpm_granular/transfer/point_groups.h>
#include <mpm_granular/transfer/points_to_grid.h>

#include <algorithm>
#include <array>
#include <type_traits>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  namespace
  {
    /// What mass and momentum follow from, as raw pointers: loops that also
    /// write to memory would read the vectors' pointers again and again.
    template <int dim>
    struct MovingPoints
    {
      MovingPoints(const Points::PointArrays<dim> &points,
                   const PointBlock<dim>          &block)
        : n_points(points.size())
        , block(block)
        , mass(points.mass.data())
        , velocity(pointers(points.velocity))
      {}

      unsigned int                    n_points; ///< of all blocks
      const PointBlock<dim>          &block;
      const double                   *mass;
      std::array<const double *, dim> velocity;
    };

    /// Mass and momentum of some points of a cell.
    template <class Cell>
    struct MassAndMomentum
    {
      static constexpr unsigned int n_nodes = Cell::n_nodes;

      Grid::CellMass<Cell> mass;
      double               momentum[Cell::dim][n_nodes];

      // The inner loops run over the nodes.
      void
      add(const MovingPoints<Cell::dim> &points, const Points::Run range)
      {
        for (std::size_t p = range.begin; p < range.end; ++p)
          {
            double shape_value[n_nodes], weighted[n_nodes];
            for (unsigned int k = 0; k < n_nodes; ++k)
              {
                shape_value[k] =
                  points.block.shape_values[k][p - points.block.begin];
                weighted[k] = points.mass[p] * shape_value[k];
              }
            mass.add(shape_value, weighted);
            for (unsigned int d = 0; d < Cell::dim; ++d)
              for (unsigned int k = 0; k < n_nodes; ++k)
                momentum[d][k] += points.velocity[d][p] * weighted[k];
          }
      }

      void
      copy_to(Grid::CellSums<Cell> &total) const
      {
        total.mass = mass;
        for (unsigned int d = 0; d < Cell::dim; ++d)
          std::copy_n(momentum[d], n_nodes, total.momentum[d].begin());
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

      /// Four points at a time without a branch for each: lengths of ranges
      /// cannot be predicted. Those that do not belong to the range have no
      /// mass.
      void
      add(const MovingPoints<3> &points, const Points::Run range)
      {
        for_each_group(range, points.n_points, [&](const auto type, auto p) {
          using Number        = std::decay_t<decltype(type)>;
          const std::size_t i = p - points.block.begin;
          const Number      of_points =
            first_of(load<Number>(points.mass + p), range.end - p);
          Number weighted[4];
          for (unsigned int k = 0; k < 4; ++k)
            weighted[k] =
              of_points * load<Number>(&points.block.shape_values[k][i]);
          if constexpr (std::is_same_v<Number, Lanes>)
            {
              transpose(weighted); // lanes of points, then of nodes
              for (unsigned int q = 0; q < Lanes::n; ++q)
                add(points, p + q, i + q, weighted[q]);
            }
          else
            add(points,
                p,
                i,
                Lanes(weighted[0], weighted[1], weighted[2], weighted[3]));
        });
      }

      /// Adds point @p p, which is at place @p i of the block.
      void
      add(const MovingPoints<3> &points,
          const std::size_t      p,
          const std::size_t      i,
          const Lanes           &weighted)
      {
        for (unsigned int k = 0; k < 4; ++k)
          mass[k] += weighted * points.block.shape_values[k][i];
        for (unsigned int d = 0; d < 3; ++d)
          momentum[d] += weighted * points.velocity[d][p];
      }

      void
      copy_to(Grid::CellSums<Mesh::SimplexCell<3>> &total) const
      {
        for (unsigned int i = 0; i < 4; ++i)
          store(mass[i], &total.mass.entries[4 * i]);
        for (unsigned int d = 0; d < 3; ++d)
          store(momentum[d], total.momentum[d].data());
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

    /// The same for stresses.
    template <int dim>
    struct StressesOfPoints
    {
      StressesOfPoints(const Points::PointArrays<dim> &points)
        : n_points(points.size())
        , volume(points.volume.data())
        , stress(pointers(points.stress))
      {}

      unsigned int                              n_points; ///< of all blocks
      const double                             *volume;
      std::array<const double *, n_stress<dim>> stress;
    };

    /// Adds V sigma of points in sequence: with a lane for each of four points,
    /// then the sums of the lanes; of the last four only those that belong to
    /// them.
    template <int dim>
    inline void
    add_stress(const Mesh::SimplexCell<dim> &,
               const Points::PointArrays<dim> &,
               const StressesOfPoints<dim>              &of_points,
               const Points::Run                         range,
               Grid::StressSums<Mesh::SimplexCell<dim>> &sums)
    {
      // Two arrays, so that compilers keep both in registers.
      constexpr unsigned int    n_rest          = n_stress<dim> - Lanes::n;
      Lanes                     first[Lanes::n] = {0., 0., 0., 0.};
      std::array<Lanes, n_rest> rest;
      rest.fill(0.);
      for_each_group(range, of_points.n_points, [&](const auto type, auto p) {
        using Number = std::decay_t<decltype(type)>;
        const Number volume =
          first_of(load<Number>(of_points.volume + p), range.end - p);
        const auto part = [&](const unsigned int s) {
          return volume * load<Number>(of_points.stress[s] + p);
        };
        for (unsigned int s = 0; s < Lanes::n; ++s)
          accumulate(first[s], part(s));
        for (unsigned int s = 0; s < n_rest; ++s)
          accumulate(rest[s], part(Lanes::n + s));
      });
      transpose(first);
      store(load<Lanes>(sums.stress.data()) +
              ((first[0] + first[1]) + (first[2] + first[3])),
            sums.stress.data());
      for (unsigned int s = 0; s < n_rest; ++s)
        sums.stress[Lanes::n + s] += sum_of(rest[s]);
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
      for (std::size_t p = range.begin; p < range.end; ++p)
        add_force(cell, points, of_points, p, sums);
    }
  } // namespace

  template <int dim>
  void
  add_mass_and_momentum(const Mesh::BackgroundMesh<dim> &mesh,
                        const Points::PointArrays<dim>  &points,
                        const PointBlock<dim>           &block,
                        Grid::NodalFields<dim>          &fields)
  {
    mesh.visit([&](const auto &cells) {
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      auto                   &active = fields.template cells<Cell>();
      const MovingPoints<dim> of_points(points, block);
      for (const auto &part : block.parts)
        if (part.cell != Mesh::no_cell)
          {
            MassAndMomentum<Cell> sums{};
            sums.add(of_points, part.points);
            // A new cell is not read right after it was written, which would
            // have to wait for the writing: 3 % of a step.
            const bool is_new = !fields.is_active_cell(part.cell);
            auto      &total  = fields.sums_of(active, part.cell);
            is_new ? sums.copy_to(total) : sums.add_to(total);
          }
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
      for (const auto &part : block.parts)
        if (part.cell != Mesh::no_cell)
          {
            Sums sums{};
            add_stress(cells[part.cell], points, of_points, part.points, sums);
            fields.sums_of(active, part.cell).internal += sums;
          }
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
