#include <mpm_granular/core/lanes.h>
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
    /// A vector field in a cell, from its values at the nodes.
    template <class Cell>
    struct CellField;

    /// A linear field in a simplex: value at vertex 0 and gradient, u_i(x) =
    /// a_i
    /// + G_ij (x - x_0)_j. Cheaper per point than shape functions: they are not
    /// needed at all.
    template <int dim>
    struct CellField<Mesh::SimplexCell<dim>>
    {
      using Cell = Mesh::SimplexCell<dim>;

      double value[dim];
      double gradient[dim][dim];

      /// @p nodal gives the field's value at node k.
      template <class NodalValue>
      CellField(const Cell &cell, NodalValue &&nodal)
      {
        const Tensor<1, dim> &first = nodal(0);
        for (unsigned int i = 0; i < dim; ++i)
          {
            value[i] = first[i];
            for (unsigned int j = 0; j < dim; ++j)
              gradient[i][j] = 0.;
          }
        for (unsigned int k = 0; k < dim; ++k)
          {
            const Tensor<1, dim> &other = nodal(k + 1);
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                gradient[i][j] += (other[i] - first[i]) * cell.gradient[k][j];
          }
      }

      /// What the fields of a cell need to know of a place.
      template <class Number>
      static std::array<Number, dim>
      place(const Cell &cell, const std::array<Number, dim> &x)
      {
        std::array<Number, dim> offset;
        for (unsigned int d = 0; d < dim; ++d)
          offset[d] = x[d] - cell.origin[d];
        return offset;
      }

      template <class Number>
      Number
      operator()(const unsigned int             i,
                 const std::array<Number, dim> &offset) const
      {
        Number sum = value[i];
        for (unsigned int j = 0; j < dim; ++j)
          sum += gradient[i][j] * offset[j];
        return sum;
      }

      Tensor<2, dim>
      gradient_tensor() const
      {
        Tensor<2, dim> result;
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            result[i][j] = gradient[i][j];
        return result;
      }
    };

    /// The same in space, set up with a lane for each component of the field;
    /// the fourth one has no meaning. Setting up takes half of the time of a
    /// run of four points otherwise.
    template <>
    struct CellField<Mesh::SimplexCell<3>>
    {
      using Cell = Mesh::SimplexCell<3>;

      std::array<double, Lanes::n>                value;
      std::array<std::array<double, Lanes::n>, 3> derivative; ///< by x_j

      /// @param nodal three numbers with a fourth one behind them.
      template <class NodalValue>
      CellField(const Cell &cell, NodalValue &&nodal)
      {
        const auto first = load<Lanes>(&nodal(0)[0]);
        Lanes      change[3];
        for (unsigned int k = 0; k < 3; ++k)
          change[k] = load<Lanes>(&nodal(k + 1)[0]) - first;
        store(first, value.data());
        for (unsigned int j = 0; j < 3; ++j)
          store(change[0] * cell.gradient[0][j] +
                  change[1] * cell.gradient[1][j] +
                  change[2] * cell.gradient[2][j],
                derivative[j].data());
      }

      template <class Number>
      static std::array<Number, 3>
      place(const Cell &cell, const std::array<Number, 3> &x)
      {
        return {{x[0] - cell.origin[0],
                 x[1] - cell.origin[1],
                 x[2] - cell.origin[2]}};
      }

      template <class Number>
      Number
      operator()(const unsigned int           i,
                 const std::array<Number, 3> &offset) const
      {
        return value[i] + derivative[0][i] * offset[0] +
               derivative[1][i] * offset[1] + derivative[2][i] * offset[2];
      }

      dealii::Tensor<2, 3>
      gradient_tensor() const
      {
        dealii::Tensor<2, 3> result;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = 0; j < 3; ++j)
            result[i][j] = derivative[j][i];
        return result;
      }
    };

    /// A field of products of linear functions in a box.
    template <int dim>
    struct CellField<Mesh::BoxCell<dim>>
    {
      using Cell                            = Mesh::BoxCell<dim>;
      static constexpr unsigned int n_nodes = Cell::n_nodes;

      double value[dim][n_nodes];

      template <class NodalValue>
      CellField(const Cell &, NodalValue &&nodal)
      {
        for (unsigned int k = 0; k < n_nodes; ++k)
          {
            const Tensor<1, dim> &of_node = nodal(k);
            for (unsigned int d = 0; d < dim; ++d)
              value[d][k] = of_node[d];
          }
      }

      /// The shape values.
      template <class Number>
      static std::array<Number, n_nodes>
      place(const Cell &cell, const std::array<Number, dim> &x)
      {
        return Cell::values_at(cell.unit_coordinates(x));
      }

      template <class Number>
      Number
      operator()(const unsigned int                 i,
                 const std::array<Number, n_nodes> &shape_values) const
      {
        Number sum = 0.;
        for (unsigned int k = 0; k < n_nodes; ++k)
          sum += shape_values[k] * value[i][k];
        return sum;
      }
    };
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
    const unsigned int n_points     = points.size();
    const auto         position     = pointers(points.position);
    const auto         velocity     = pointers(points.velocity);
    const auto         new_position = pointers(block.position);
    const auto         new_velocity = pointers(block.velocity);
    const double       kept         = 1. - pic_factor;

    mesh.visit([&](const auto &cells) {
      using Cell  = typename std::decay_t<decltype(cells)>::value_type;
      using Field = CellField<Cell>;
      for (const auto &run : block.runs)
        {
          for (unsigned int d = 0; d < dim; ++d)
            {
              Points::fetch_ahead(position[d], run.begin);
              Points::fetch_ahead(velocity[d], run.begin);
            }
          Points::fetch_ahead(points.mass.data(), run.begin);
          const Cell                  &cell = cells[points.cell[run.begin]];
          const Grid::NodeMotion<dim> *node[Cell::n_nodes];
          for (unsigned int k = 0; k < Cell::n_nodes; ++k)
            node[k] = &fields.motion[fields.slot_of(cell.node[k])];
          const Field moving(
            cell, [&](const unsigned int k) -> auto & {
              return node[k]->velocity;
            });
          const Field change(
            cell, [&](const unsigned int k) -> auto & {
              return node[k]->change;
            });

          for_each_group(run, n_points, [&](const auto type, const auto p) {
            using Number             = std::decay_t<decltype(type)>;
            const unsigned int i     = p - block.begin;
            const auto         x     = load_all<Number>(position, p);
            const auto         place = Field::place(cell, x);
            for (unsigned int d = 0; d < dim; ++d)
              {
                store(kept * load<Number>(velocity[d] + p) + change(d, place),
                      new_velocity[d] + i);
                store(x[d] + time_step * moving(d, place), new_position[d] + i);
              }
          });
        }
    });
    for (unsigned int d = 0; d < dim; ++d)
      {
        const unsigned int n = block.end - block.begin;
        std::copy_n(new_position[d], n, position[d] + block.begin);
        std::copy_n(new_velocity[d], n, velocity[d] + block.begin);
      }
  }

  namespace
  {
    /// Asks the memory for a cell.
    template <class Cell>
    void
    fetch(const Cell &cell)
    {
      constexpr unsigned int line  = 64;
      const char            *begin = reinterpret_cast<const char *>(&cell);
      for (unsigned int i = 0; i < sizeof(Cell); i += line)
        __builtin_prefetch(begin + i);
    }

    /// In a simplex the velocity gradient is one for all points.
    template <int dim, class Straining>
    void
    evaluate_gradients(const Mesh::SimplexCell<dim> &cell,
                       Straining                   &&straining,
                       const Points::PointArrays<dim> &,
                       const Points::Run run,
                       PointBlock<dim>  &block)
    {
      const CellField<Mesh::SimplexCell<dim>> field(cell, straining);
      block.gradients.push_back(field.gradient_tensor());
      block.strained.push_back(run);
    }

    template <int dim, class Straining>
    void
    evaluate_gradients(const Mesh::BoxCell<dim>       &cell,
                       Straining                     &&straining,
                       const Points::PointArrays<dim> &points,
                       const Points::Run               run,
                       PointBlock<dim>                &block)
    {
      using Cell = Mesh::BoxCell<dim>;
      const CellField<Cell> field(cell, straining);
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
                  sum += field.value[i][k] * derivatives[d][k];
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
  } // namespace

  template <int dim>
  void
  evaluate_gradients(const Mesh::BackgroundMesh<dim> &mesh,
                     const Grid::NodalFields<dim>    &fields,
                     const Points::PointArrays<dim>  &points,
                     PointBlock<dim>                 &block)
  {
    block.gradients.clear();
    block.strained.clear();
    mesh.visit([&](const auto &cells) {
      for (const auto &run : block.runs)
        {
          const auto        &cell  = cells[points.cell[run.begin]];
          const unsigned int ahead = run.begin + Points::n_points_ahead;
          if (ahead < points.size())
            fetch(cells[points.cell[ahead]]);
          evaluate_gradients(
            cell,
            [&](const unsigned int k) -> auto & {
              return fields.motion[fields.slot_of(cell.node[k])].straining;
            },
            points,
            run,
            block);
        }
    });
  }

  void
  Relocation::operator+=(const Relocation &other)
  {
    lost_point      = std::min(lost_point, other.lost_point);
    is_out_of_reach = is_out_of_reach || other.is_out_of_reach;
  }

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
  } // namespace

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

    const unsigned int n_points = points.size();
    const auto         position = pointers(points.position);
    const auto         values   = pointers(block.shape_values);
    double *const      heights  = block.heights.data();
    Relocation         result;

    mesh.visit([&](const auto &cells) {
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      for (const auto &run : block.runs)
        {
          const Cell &cell = cells[points.cell[run.begin]];
          for_each_group(run, n_points, [&](const auto type, const auto p) {
            using Number         = std::decay_t<decltype(type)>;
            const unsigned int i = p - block.begin;
            Number             at_nodes[Cell::n_nodes];
            store(evaluate(cell, load_all<Number>(position, p), at_nodes),
                  heights + i);
            for (unsigned int k = 0; k < Cell::n_nodes; ++k)
              store(at_nodes[k], values[k] + i);
          });
        }

      block.movers.clear();
      for (unsigned int p = block.begin; p < block.end; ++p)
        if (!(heights[p - block.begin] >= least))
          block.movers.push_back(p);
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
            values[k][p - block.begin] = inner[k];
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
  template Relocation relocate(const Mesh::BackgroundMesh<dim> &,           \
                               const Mesh::Partition<dim> &,                \
                               Points::PointArrays<dim> &,                  \
                               PointBlock<dim> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace mpm_granular::Transfer
