#include <mpm_granular/mesh/point_walk.h>
#include <mpm_granular/transfer/grid_to_points.h>

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
      using Place = std::array<double, dim>;

      static Place
      place(const Cell &cell, const Place &x)
      {
        Place offset;
        for (unsigned int d = 0; d < dim; ++d)
          offset[d] = x[d] - cell.origin[d];
        return offset;
      }

      double
      operator()(const unsigned int i, const Place &offset) const
      {
        double sum = value[i];
        for (unsigned int j = 0; j < dim; ++j)
          sum += gradient[i][j] * offset[j];
        return sum;
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

      using Place = std::array<double, n_nodes>; // shape values

      static Place
      place(const Cell &cell, const std::array<double, dim> &x)
      {
        std::array<double, dim> xi;
        for (unsigned int d = 0; d < dim; ++d)
          {
            xi[d] = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              xi[d] += cell.gradient[d][j] * (x[j] - cell.origin[j]);
          }
        return Cell::values_at(xi);
      }

      double
      operator()(const unsigned int i, const Place &shape_values) const
      {
        double sum = 0.;
        for (unsigned int k = 0; k < n_nodes; ++k)
          sum += shape_values[k] * value[i][k];
        return sum;
      }
    };

    /// Raw pointers to the components of a vector field of the points.
    template <std::size_t n>
    std::array<double *, n>
    pointers(std::array<std::vector<double>, n> &components)
    {
      std::array<double *, n> result;
      for (unsigned int d = 0; d < n; ++d)
        result[d] = components[d].data();
      return result;
    }
  } // namespace

  template <int dim>
  void
  move_points(const Mesh::BackgroundMesh<dim> &mesh,
              const Grid::NodalFields<dim>    &fields,
              const PointBlock<dim>           &block,
              const double                     time_step,
              const double                     pic_factor,
              Points::PointArrays<dim>        &points)
  {
    const auto   position = pointers(points.position);
    const auto   velocity = pointers(points.velocity);
    const double kept     = 1. - pic_factor;

    mesh.visit([&](const auto &cells) {
      using Cell  = typename std::decay_t<decltype(cells)>::value_type;
      using Field = CellField<Cell>;
      for (const auto &run : block.runs)
        {
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

          // Points of a run do not alias: vectorised over points.
#pragma omp simd
          for (unsigned int p = run.begin; p < run.end; ++p)
            {
              std::array<double, dim> x;
              for (unsigned int d = 0; d < dim; ++d)
                x[d] = position[d][p];
              const auto place = Field::place(cell, x);
              for (unsigned int d = 0; d < dim; ++d)
                {
                  velocity[d][p] = kept * velocity[d][p] + change(d, place);
                  position[d][p] += time_step * moving(d, place);
                }
            }
        }
    });
  }

  namespace
  {
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
      Tensor<2, dim>                          gradient;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          gradient[i][j] = field.gradient[i][j];
      block.gradients.push_back(gradient);
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
          const auto &cell = cells[points.cell[run.begin]];
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
    /// face. For a loop over points: no arrays that would keep it from being
    /// vectorised.
    template <int dim>
    inline double
    evaluate(const Mesh::SimplexCell<dim>               &cell,
             const std::array<double, std::size_t(dim)> &x,
             double (&values)[dim + 1])
    {
      double first = 1.;
      double low   = 1.;
      for (unsigned int k = 0; k < dim; ++k)
        {
          double value = 0.;
          for (unsigned int d = 0; d < dim; ++d)
            value += cell.gradient[k][d] * (x[d] - cell.origin[d]);
          values[k + 1] = value;
          first -= value;
          low = std::min(low, value);
        }
      values[0] = first;
      return std::min(low, first);
    }

    template <int dim>
    inline double
    evaluate(const Mesh::BoxCell<dim>                   &cell,
             const std::array<double, std::size_t(dim)> &x,
             double (&values)[Mesh::BoxCell<dim>::n_nodes])
    {
      using Cell                  = Mesh::BoxCell<dim>;
      double                  low = 1.;
      std::array<double, dim> xi;
      for (unsigned int k = 0; k < dim; ++k)
        {
          xi[k] = 0.;
          for (unsigned int d = 0; d < dim; ++d)
            xi[k] += cell.gradient[k][d] * (x[d] - cell.origin[d]);
          low = std::min(low, std::min(xi[k], 1. - xi[k]));
        }
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

    const auto position = pointers(points.position);
    const auto values   = pointers(block.shape_values);
    Relocation result;

    mesh.visit([&](const auto &cells) {
      using Cell = typename std::decay_t<decltype(cells)>::value_type;
      for (const auto &run : block.runs)
        {
          const unsigned int host          = points.cell[run.begin];
          const Cell        &cell          = cells[host];
          double             lowest_of_run = 1.;

#pragma omp simd reduction(min : lowest_of_run)
          for (unsigned int p = run.begin; p < run.end; ++p)
            {
              std::array<double, dim> x;
              for (unsigned int d = 0; d < dim; ++d)
                x[d] = position[d][p];
              double       at_nodes[Cell::n_nodes];
              const double low = evaluate(cell, x, at_nodes);
              for (unsigned int k = 0; k < Cell::n_nodes; ++k)
                values[k][p - block.begin] = at_nodes[k];
              lowest_of_run = std::min(lowest_of_run, low);
            }
          if (lowest_of_run >= least)
            continue;

          for (unsigned int p = run.begin; p < run.end; ++p)
            {
              const auto x       = points.location(p);
              const auto heights = cell.heights(x);
              if (*std::min_element(heights.begin(), heights.end()) >= least)
                continue;

              const auto found = Mesh::walk_to(cells, x, host);
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
        }
    });
    return result;
  }

#define INSTANTIATE(dim)                                                    \
  template void       move_points(const Mesh::BackgroundMesh<dim> &,        \
                                  const Grid::NodalFields<dim> &,           \
                                  const PointBlock<dim> &,                  \
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
