#include <mpm_granular/transfer/grid_to_points.h>
#include <mpm_granular/transfer/moving_least_squares.h>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  void
  MovingLeastSquares<dim>::BlockFunctions::reinit(
    const Mesh::BackgroundMesh<dim> &mesh)
  {
    at_places.reinit(mesh);
    cells.clear();
  }

  template <int dim>
  void
  MovingLeastSquares<dim>::BlockFunctions::find(
    const Points::PointArrays<dim> &points,
    const PointBlock<dim>          &block)
  {
    const unsigned int n_points = block.end - block.begin;
    bool               is_same  = cells.size() == n_points;
    for (unsigned int i = 0; is_same && i < n_points; ++i)
      is_same = cells[i] == points.cell[block.begin + i] &&
                places[i] == points.location(block.begin + i);
    begin = block.begin;
    if (is_same)
      return;
    cells.clear();
    places.clear();
    functions.clear();
    first.assign(1, 0);
    for (unsigned int p = block.begin; p < block.end; ++p)
      {
        cells.push_back(points.cell[p]);
        places.push_back(points.location(p));
        if (cells.back() != Mesh::no_cell)
          at_places.evaluate(cells.back(), places.back(), functions);
        first.push_back(functions.size());
      }
  }

  template <int dim>
  void
  MovingLeastSquares<dim>::add_parameters(ParameterHandler &)
  {}

  template <int dim>
  void
  MovingLeastSquares<dim>::reinit(const Mesh::BackgroundMesh<dim> &mesh,
                                  const Mesh::Partition<dim> &,
                                  const std::vector<double> &)
  {
    require(mesh.cell_kind() == Mesh::CellKind::simplex,
            "Scheme/Averaging = moving least squares works on simplices only; "
            "on hypercubes it must be 'none'.");
    functions.reinit(mesh);
  }

  template <int dim>
  void
  MovingLeastSquares<dim>::add_mass_and_momentum(
    const Mesh::BackgroundMesh<dim> &,
    const Points::PointArrays<dim> &points,
    const PointBlock<dim>          &block,
    Grid::NodalFields<dim>         &fields)
  {
    for (const auto &part : block.parts)
      if (part.cell != Mesh::no_cell)
        fields.activate(part.cell);
    functions.find(points, block);
    for (unsigned int p = block.begin; p < block.end; ++p)
      {
        Tensor<1, dim> velocity;
        for (unsigned int d = 0; d < dim; ++d)
          velocity[d] = points.velocity[d][p];
        fields.spread.add(points.mass[p], velocity, functions.of_point(p));
      }
  }

  template <int dim>
  void
  MovingLeastSquares<dim>::add_stresses(const Points::PointArrays<dim> &points,
                                        const PointBlock<dim>          &block,
                                        Grid::NodalFields<dim>         &fields)
  {
    functions.find(points, block);
    for (unsigned int p = block.begin; p < block.end; ++p)
      {
        Tensor<2, dim> stress; // times -V
        for (unsigned int s = 0; s < n_stress<dim>; ++s)
          {
            const unsigned int i = stress_index[s][0], j = stress_index[s][1];
            if (i < dim && j < dim)
              stress[i][j] = stress[j][i] =
                -points.volume[p] * points.stress[s][p];
          }
        for (const auto &function : functions.of_point(p))
          fields.spread.add_force(function.node, stress * function.gradient);
      }
  }

  template <int dim>
  void
  MovingLeastSquares<dim>::evaluate(const Grid::NodalFields<dim>   &fields,
                                    const Points::PointArrays<dim> &points,
                                    PointBlock<dim>                &block) const
  {
    functions.find(points, block);
    block.gradients.clear();
    block.strained.clear();
    for (unsigned int p = block.begin; p < block.end; ++p)
      {
        Tensor<2, dim> gradient;
        for (const auto &function : functions.of_point(p))
          gradient += outer_product(
            fields.motion[fields.slot_of(function.node)].straining,
            function.gradient);
        block.gradients.push_back(gradient);
        block.strained.push_back({p, p + 1});
      }
  }

  template <int dim>
  void
  MovingLeastSquares<dim>::move_points(const Mesh::BackgroundMesh<dim> &mesh,
                                       const Grid::NodalFields<dim>    &fields,
                                       PointBlock<dim>                 &block,
                                       const double              time_step,
                                       const double              pic_factor,
                                       Points::PointArrays<dim> &points) const
  {
    functions.find(points, block);
    for (unsigned int p = block.begin; p < block.end; ++p)
      {
        Tensor<1, dim> velocity, change;
        for (const auto &function : functions.of_point(p))
          {
            const auto &node = fields.motion[fields.slot_of(function.node)];
            velocity += function.value * node.velocity;
            change += function.value * node.change;
          }
        for (unsigned int d = 0; d < dim; ++d)
          {
            points.position[d][p] += time_step * velocity[d];
            points.velocity[d][p] =
              (1. - pic_factor) * points.velocity[d][p] + change[d];
          }
      }
    find_shape_values(mesh, points, block);
  }

  template class MovingLeastSquares<2>;
  template class MovingLeastSquares<3>;

  namespace
  {
    const std::string documentation =
      "smooth shape functions over the cells around each point (UMLS), for "
      "all that points and nodes exchange: most accurate where points cross "
      "cells, but the dearest.";
    const AveragingRegistry<2>::Entry<MovingLeastSquares<2>>
      mls_2d("moving least squares", documentation);
    const AveragingRegistry<3>::Entry<MovingLeastSquares<3>>
      mls_3d("moving least squares", documentation);
  } // namespace
} // namespace mpm_granular::Transfer
