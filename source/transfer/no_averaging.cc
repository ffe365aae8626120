#include <mpm_granular/transfer/grid_to_points.h>
#include <mpm_granular/transfer/no_averaging.h>
#include <mpm_granular/transfer/points_to_grid.h>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  void
  NoAveraging<dim>::add_parameters(ParameterHandler &)
  {}

  template <int dim>
  void
  NoAveraging<dim>::reinit(const Mesh::BackgroundMesh<dim> &new_mesh,
                           const Mesh::Partition<dim> &,
                           const std::vector<double> &)
  {
    mesh = &new_mesh;
  }

  template <int dim>
  void
  NoAveraging<dim>::add_stresses(const Points::PointArrays<dim> &points,
                                 const PointBlock<dim>          &block,
                                 Grid::NodalFields<dim>         &fields)
  {
    add_stress(*mesh, points, block, fields);
  }

  template <int dim>
  void
  NoAveraging<dim>::evaluate(const Grid::NodalFields<dim>   &fields,
                             const Points::PointArrays<dim> &points,
                             PointBlock<dim>                &block) const
  {
    evaluate_gradients(*mesh, fields, points, block);
  }

  template class NoAveraging<2>;
  template class NoAveraging<3>;

  namespace
  {
    const std::string documentation =
      "each point acts on its cell with its own stress and volume, as in the "
      "paper.";
    const AveragingRegistry<2>::Entry<NoAveraging<2>> none_2d("none",
                                                              documentation);
    const AveragingRegistry<3>::Entry<NoAveraging<3>> none_3d("none",
                                                              documentation);
  } // namespace
} // namespace mpm_granular::Transfer
