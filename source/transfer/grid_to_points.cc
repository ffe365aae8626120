#include <mpm_granular/mesh/point_walk.h>
#include <mpm_granular/transfer/grid_to_points.h>

#include <algorithm>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  namespace
  {
    /// A linear field in a simplex: value at vertex 0 and gradient, u_i(x) =
    /// a_i
    /// + G_ij (x - x_0)_j. Cheaper per point than shape functions: they are not
    /// needed at all.
    template <int dim>
    struct LinearField
    {
      double value[dim];
      double gradient[dim][dim];

      /// @p nodal gives the field's value at node k = 0..dim.
      template <class NodalValue>
      LinearField(const Mesh::SimplexCell<dim> &cell, NodalValue &&nodal)
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

      double
      operator()(const unsigned int i, const double (&offset)[dim]) const
      {
        double sum = value[i];
        for (unsigned int j = 0; j < dim; ++j)
          sum += gradient[i][j] * offset[j];
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

    for (const auto &run : block.runs)
      {
        const auto                  &cell = mesh.cell(points.cell[run.begin]);
        const Grid::NodeMotion<dim> *node[dim + 1];
        for (unsigned int k = 0; k <= dim; ++k)
          node[k] = &fields.motion[fields.slot_of(cell.node[k])];
        const LinearField<dim> moving(
          cell, [&](const unsigned int k) -> auto & {
            return node[k]->velocity;
          });
        const LinearField<dim> change(
          cell, [&](const unsigned int k) -> auto & {
            return node[k]->change;
          });

        // Points of a run do not alias: vectorised over points.
#pragma omp simd
        for (unsigned int p = run.begin; p < run.end; ++p)
          {
            double offset[dim];
            for (unsigned int d = 0; d < dim; ++d)
              offset[d] = position[d][p] - cell.origin[d];
            for (unsigned int d = 0; d < dim; ++d)
              {
                velocity[d][p] = kept * velocity[d][p] + change(d, offset);
                position[d][p] += time_step * moving(d, offset);
              }
          }
      }
  }

  template <int dim>
  void
  evaluate_gradients(const Mesh::BackgroundMesh<dim> &mesh,
                     const Grid::NodalFields<dim>    &fields,
                     const Points::PointArrays<dim>  &points,
                     PointBlock<dim>                 &block)
  {
    for (unsigned int r = 0; r < block.runs.size(); ++r)
      {
        const auto &cell = mesh.cell(points.cell[block.runs[r].begin]);
        const LinearField<dim> straining(
          cell, [&](const unsigned int k) -> auto & {
            return fields.motion[fields.slot_of(cell.node[k])].straining;
          });
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = 0; j < dim; ++j)
            block.gradients[r][i][j] = straining.gradient[i][j];
      }
  }

  void
  Relocation::operator+=(const Relocation &other)
  {
    lost_point      = std::min(lost_point, other.lost_point);
    is_out_of_reach = is_out_of_reach || other.is_out_of_reach;
  }

  template <int dim>
  Relocation
  relocate(const Mesh::BackgroundMesh<dim> &mesh,
           const Mesh::Partition<dim>      &partition,
           Points::PointArrays<dim>        &points,
           PointBlock<dim>                 &block)
  {
    // A shape value this small would give a node a mass of round-off; the point
    // then counts as this far inside (in barycentric coordinates).
    constexpr double least = 1e-10;

    const auto position = pointers(points.position);
    const auto values   = pointers(block.shape_values);
    Relocation result;

    for (const auto &run : block.runs)
      {
        const unsigned int host          = points.cell[run.begin];
        const auto        &cell          = mesh.cell(host);
        double             lowest_of_run = 1.;

#pragma omp simd reduction(min : lowest_of_run)
        for (unsigned int p = run.begin; p < run.end; ++p)
          {
            const unsigned int q     = p - block.begin;
            double             first = 1.;
            double             low   = 1.;
            for (unsigned int k = 0; k < dim; ++k)
              {
                double value = 0.;
                for (unsigned int d = 0; d < dim; ++d)
                  value +=
                    cell.gradient[k][d] * (position[d][p] - cell.origin[d]);
                values[k + 1][q] = value;
                first -= value;
                low = std::min(low, value);
              }
            values[0][q]  = first;
            lowest_of_run = std::min(lowest_of_run, std::min(low, first));
          }
        if (lowest_of_run >= least)
          continue;

        for (unsigned int p = run.begin; p < run.end; ++p)
          {
            const unsigned int q   = p - block.begin;
            double             low = values[0][q];
            for (unsigned int k = 1; k <= dim; ++k)
              low = std::min(low, values[k][q]);
            if (low >= least)
              continue;

            const auto found = Mesh::walk_to(mesh, points.location(p), host);
            points.cell[p]   = found.cell;
            if (found.cell == Mesh::no_cell)
              {
                result.lost_point = std::min(result.lost_point, p);
                continue;
              }
            result.is_out_of_reach =
              result.is_out_of_reach || !partition.is_reachable(found.cell);
            double sum = 0.;
            for (unsigned int k = 0; k <= dim; ++k)
              sum += std::max(found.shape_values[k], least);
            for (unsigned int k = 0; k <= dim; ++k)
              values[k][q] = std::max(found.shape_values[k], least) / sum;
          }
      }
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
