#include <mpm_granular/core/fetch.h>
#include <mpm_granular/core/lanes.h>
#include <mpm_granular/core/marks.h>
#include <mpm_granular/mesh/point_walk.h>
#include <mpm_granular/points/fetch_ahead.h>
#include <mpm_granular/transfer/grid_to_points.h>
#include <mpm_granular/transfer/point_groups.h>

#include <algorithm>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  namespace
  {
    /// Sets the shape values at a place and returns the least height above a
    /// face.
    template <class Number, int dim>
    inline Number
    evaluate(const Mesh::SimplexCell<dim>               &cell,
             const std::array<Number, std::size_t(dim)> &x,
             Number (&values)[dim + 1])
    {
      Number first = 1.;
      Number low   = 1.;
      for (unsigned int k = 0; k < dim; ++k)
        {
          Number value = cell.gradient[k][0] * (x[0] - cell.origin[0]);
          for (unsigned int d = 1; d < dim; ++d)
            value += cell.gradient[k][d] * (x[d] - cell.origin[d]);
          values[k + 1] = value;
          first -= value;
          low = minimum(low, value);
        }
      values[0] = first;
      return minimum(low, first);
    }

    template <class Number, int dim>
    inline Number
    evaluate(const Mesh::BoxCell<dim>                   &cell,
             const std::array<Number, std::size_t(dim)> &x,
             Number (&values)[Mesh::BoxCell<dim>::n_nodes])
    {
      using Cell     = Mesh::BoxCell<dim>;
      const auto xi  = cell.unit_coordinates(x);
      Number     low = 1.;
      for (unsigned int k = 0; k < dim; ++k)
        low = minimum(low, minimum(xi[k], 1. - xi[k]));
      const auto of_nodes = Cell::values_at(xi);
      for (unsigned int k = 0; k < Cell::n_nodes; ++k)
        values[k] = of_nodes[k];
      return low;
    }

    /// Sets the block's shape values and heights of the points from place @p i
    /// on, which are at @p x.
    template <class Number, int dim, class Cell>
    inline void
    set_shape_values(const Cell                                 &cell,
                     const std::array<Number, std::size_t(dim)> &x,
                     const std::size_t                           i,
                     PointBlock<dim>                            &block)
    {
      Number at_nodes[Cell::n_nodes];
      store(evaluate(cell, x, at_nodes), &block.heights[i]);
      for (unsigned int k = 0; k < Cell::n_nodes; ++k)
        store(at_nodes[k], &block.shape_values[k][i]);
    }
  } // namespace

  template <int dim>
  void
  move_points(const Mesh::BackgroundMesh<dim> &mesh,
              const Grid::NodalFields<dim>    &fields,
              PointBlock<dim>                 &block,
              const double                     time_step,
              const double                     pic_factor,
              Points::PointArrays<dim>        &points)
  {
    const unsigned int n_points = points.size();
    const auto         position = pointers(points.position);
    const auto         velocity = pointers(points.velocity);
    const double       kept     = 1. - pic_factor;

    mesh.visit([&](const auto &cells) {
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      for (const auto &run : block.runs)
        {
          const Cell                  &cell = cells[points.cell[run.begin]];
          const Grid::NodeMotion<dim> *node[Cell::n_nodes];
          for (unsigned int k = 0; k < Cell::n_nodes; ++k)
            node[k] = &fields.motion[fields.slot_of(cell.node[k])];

          // Directly with the values at the nodes: gradients of the fields,
          // once for a run, would be more work where runs are short.
          for_each_group(run, n_points, [&](const auto type, const auto p) {
            using Number = std::decay_t<decltype(type)>;
            auto   x     = load_all<Number>(position, p);
            auto   v     = load_all<Number>(velocity, p);
            Number at_nodes[Cell::n_nodes];
            evaluate(cell, x, at_nodes);
            for (unsigned int d = 0; d < dim; ++d)
              {
                Number moving = at_nodes[0] * node[0]->velocity[d];
                Number change = at_nodes[0] * node[0]->change[d];
                for (unsigned int k = 1; k < Cell::n_nodes; ++k)
                  {
                    moving += at_nodes[k] * node[k]->velocity[d];
                    change += at_nodes[k] * node[k]->change[d];
                  }
                x[d] += time_step * moving;
                v[d] = kept * v[d] + change;
              }
            const std::size_t i = p - block.begin;
            set_shape_values(cell, x, i, block);
            for (unsigned int d = 0; d < dim; ++d)
              {
                store(x[d], &block.position[d][i]);
                store(v[d], &block.velocity[d][i]);
              }
          });
        }
    });
    for (unsigned int d = 0; d < dim; ++d)
      {
        const unsigned int n = block.end - block.begin;
        std::copy_n(block.position[d].data(), n, position[d] + block.begin);
        std::copy_n(block.velocity[d].data(), n, velocity[d] + block.begin);
      }
  }

  namespace
  {
    /// Asks the memory for the cell of the point n_points_ahead of @p point.
    template <int dim, class Cell>
    void
    fetch_ahead(const std::vector<Cell>        &cells,
                const Points::PointArrays<dim> &points,
                const unsigned int              point)
    {
      const unsigned int ahead = point + Points::n_points_ahead;
      if (ahead < points.size())
        fetch(&cells[points.cell[ahead]]);
    }

    /// Sum over the nodes of value times gradient of the shape function.
    template <int dim>
    inline void
    set_gradient(const Mesh::SimplexCell<dim>                      &cell,
                 const std::array<const Tensor<1, dim> *, dim + 1> &value,
                 Tensor<2, dim>                                    &gradient)
    {
      gradient = Tensor<2, dim>();
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            gradient[i][j] +=
              ((*value[k + 1])[i] - (*value[0])[i]) * cell.gradient[k][j];
    }

    /// In space with a lane for each derivative; the fourth one has no meaning.
    inline void
    set_gradient(const Mesh::SimplexCell<3>                &cell,
                 const std::array<const Tensor<1, 3> *, 4> &value,
                 Tensor<2, 3>                              &gradient)
    {
      const auto g1 = load<Lanes>(cell.gradient[0].data());
      const auto g2 = load<Lanes>(cell.gradient[1].data());
      // Behind the last one are integers, as numbers so small that some
      // processors take long for them.
      const auto g3 = first_of(load<Lanes>(cell.gradient[2].data()), 3);
      const auto g0 = g1 + g2 + g3; // less that of node 0
      for (unsigned int i = 0; i < 3; ++i)
        {
          const Lanes row = (*value[1])[i] * g1 + (*value[2])[i] * g2 +
                            (*value[3])[i] * g3 - (*value[0])[i] * g0;
          for (unsigned int j = 0; j < 3; ++j)
            gradient[i][j] = row.data[j];
        }
    }

    /// In a simplex the velocity gradient is one for all points.
    template <int dim>
    void
    evaluate_gradients(const std::vector<Mesh::SimplexCell<dim>> &cells,
                       const Grid::NodalFields<dim>              &fields,
                       const Points::PointArrays<dim>            &points,
                       PointBlock<dim>                           &block)
    {
      block.strained = block.runs;
      block.gradients.resize(block.runs.size());
      for (unsigned int r = 0; r < block.runs.size(); ++r)
        {
          const unsigned int begin = block.runs[r].begin;
          const auto        &cell  = cells[points.cell[begin]];
          fetch_ahead(cells, points, begin);
          std::array<const Tensor<1, dim> *, dim + 1> value;
          for (unsigned int k = 0; k < dim + 1; ++k)
            value[k] = &fields.motion[fields.slot_of(cell.node[k])].straining;
          set_gradient(cell, value, block.gradients[r]);
        }
    }

    template <int dim>
    void
    evaluate_gradients(const std::vector<Mesh::BoxCell<dim>> &cells,
                       const Grid::NodalFields<dim>          &fields,
                       const Points::PointArrays<dim>        &points,
                       PointBlock<dim>                       &block)
    {
      using Cell = Mesh::BoxCell<dim>;
      block.gradients.clear();
      block.strained.clear();
      for (const auto &run : block.runs)
        {
          const auto &cell = cells[points.cell[run.begin]];
          fetch_ahead(cells, points, run.begin);
          double value[dim][Cell::n_nodes];
          for (unsigned int k = 0; k < Cell::n_nodes; ++k)
            {
              const auto &node = fields.motion[fields.slot_of(cell.node[k])];
              for (unsigned int d = 0; d < dim; ++d)
                value[d][k] = node.straining[d];
            }
          for (unsigned int p = run.begin; p < run.end; ++p)
            {
              const auto derivatives =
                Cell::derivatives_at(cell.unit_coordinates(points.location(p)));
              double along[dim][dim]; // derivatives of u_i by xi_d
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int d = 0; d < dim; ++d)
                  {
                    double sum = 0.;
                    for (unsigned int k = 0; k < Cell::n_nodes; ++k)
                      sum += value[i][k] * derivatives[d][k];
                    along[i][d] = sum;
                  }
              Tensor<2, dim> gradient;
              for (unsigned int i = 0; i < dim; ++i)
                for (unsigned int j = 0; j < dim; ++j)
                  for (unsigned int d = 0; d < dim; ++d)
                    gradient[i][j] += along[i][d] * cell.gradient[d][j];
              block.gradients.push_back(gradient);
              block.strained.push_back({p, p + 1});
            }
        }
    }
  } // namespace

  template <int dim>
  void
  evaluate_gradients(const Mesh::BackgroundMesh<dim> &mesh,
                     const Grid::NodalFields<dim>    &fields,
                     const Points::PointArrays<dim>  &points,
                     PointBlock<dim>                 &block)
  {
    mesh.visit([&](const auto &cells) {
      evaluate_gradients(cells, fields, points, block);
    });
  }

  void
  Relocation::operator+=(const Relocation &other)
  {
    lost_point      = std::min(lost_point, other.lost_point);
    is_out_of_reach = is_out_of_reach || other.is_out_of_reach;
  }

  template <int dim>
  void
  find_shape_values(const Mesh::BackgroundMesh<dim> &mesh,
                    const Points::PointArrays<dim>  &points,
                    PointBlock<dim>                 &block)
  {
    const unsigned int n_points = points.size();
    const auto         position = pointers(points.position);
    mesh.visit([&](const auto &cells) {
      for (const auto &run : block.runs)
        {
          const auto &cell = cells[points.cell[run.begin]];
          for_each_group(run, n_points, [&](const auto type, const auto p) {
            using Number = std::decay_t<decltype(type)>;
            set_shape_values(cell,
                             load_all<Number>(position, p),
                             p - block.begin,
                             block);
          });
        }
    });
  }

  template <int dim>
  Relocation
  relocate(const Mesh::BackgroundMesh<dim> &mesh,
           const Mesh::Partition<dim>      &partition,
           Points::PointArrays<dim>        &points,
           PointBlock<dim>                 &block)
  {
    // A shape value this small would give a node a mass of round-off; the point
    // then counts as this far inside (in heights of the cell).
    constexpr double least = 1e-10;

    Relocation result;

    mesh.visit([&](const auto &cells) {
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      block.movers.clear();
      for_each_marked(
        block.end - block.begin,
        [&](const std::size_t i) { return !(block.heights[i] >= least); },
        [&](const unsigned int i) { block.movers.push_back(block.begin + i); });
      for (const unsigned int p : block.movers)
        {
          const auto x     = points.location(p);
          const auto found = Mesh::walk_to(cells, x, points.cell[p]);
          points.cell[p]   = found.cell;
          if (found.cell == Mesh::no_cell)
            {
              result.lost_point = std::min(result.lost_point, p);
              continue;
            }
          if (found.is_beyond_reach || !partition.is_reachable(found.cell))
            result.is_out_of_reach = true;
          const auto inner = cells[found.cell].inner_shape_values(x, least);
          for (unsigned int k = 0; k < Cell::n_nodes; ++k)
            block.shape_values[k][p - block.begin] = inner[k];
        }
    });
    block.find_parts(points);
    return result;
  }

#define INSTANTIATE(dim)                                                    \
  template void       move_points(const Mesh::BackgroundMesh<dim> &,        \
                                  const Grid::NodalFields<dim> &,           \
                                  PointBlock<dim> &,                        \
                                  const double,                             \
                                  const double,                             \
                                  Points::PointArrays<dim> &);              \
  template void       evaluate_gradients(const Mesh::BackgroundMesh<dim> &, \
                                         const Grid::NodalFields<dim> &,    \
                                         const Points::PointArrays<dim> &,  \
                                         PointBlock<dim> &);                \
  template void       find_shape_values(const Mesh::BackgroundMesh<dim> &,  \
                                        const Points::PointArrays<dim> &,   \
                                        PointBlock<dim> &);                 \
  template Relocation relocate(const Mesh::BackgroundMesh<dim> &,           \
                               const Mesh::Partition<dim> &,                \
                               Points::PointArrays<dim> &,                  \
                               PointBlock<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace mpm_granular::Transfer
