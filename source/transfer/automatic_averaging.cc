#include <mpm_granular/transfer/automatic_averaging.h>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  AutomaticAveraging<dim>::AutomaticAveraging()
  {
    use("cells");
  }

  template <int dim>
  void
  AutomaticAveraging<dim>::use(const std::string &new_name)
  {
    name      = new_name;
    averaging = AveragingRegistry<dim>::make(name);
  }

  template <int dim>
  void
  AutomaticAveraging<dim>::add_parameters(ParameterHandler &)
  {}

  template <int dim>
  bool
  AutomaticAveraging<dim>::suit(const BodyTraits &body)
  {
    // Means around nodes come to rest slowly, if at all: a free surface in
    // balance leaves its outermost points without stress, and so without
    // strength.
    const bool is_for_nodes = is_of_simplices && !body.is_settled_first &&
                              body.points_per_cell < few_points_per_cell;
    use(!body.is_granular ? "none" : is_for_nodes ? "nodes" : "cells");
    averaging->suit(body);
    return true;
  }

  template <int dim>
  std::string
  AutomaticAveraging<dim>::name_in_use(const std::string &) const
  {
    return name;
  }

  template <int dim>
  double
  AutomaticAveraging<dim>::suitable_filter_rate() const
  {
    return averaging->suitable_filter_rate();
  }

  template <int dim>
  double
  AutomaticAveraging<dim>::suitable_shift_rate() const
  {
    return averaging->suitable_shift_rate();
  }

  template <int dim>
  void
  AutomaticAveraging<dim>::reinit(
    const Mesh::BackgroundMesh<dim> &mesh,
    const Mesh::Partition<dim>      &partition,
    const std::vector<double>       &largest_specific_volume)
  {
    is_of_simplices = mesh.cell_kind() == Mesh::CellKind::simplex;
    averaging->reinit(mesh, partition, largest_specific_volume);
  }

  template <int dim>
  void
  AutomaticAveraging<dim>::clear()
  {
    averaging->clear();
  }

  template <int dim>
  void
  AutomaticAveraging<dim>::clear_stresses()
  {
    averaging->clear_stresses();
  }

  template <int dim>
  void
  AutomaticAveraging<dim>::add_mass_and_momentum(
    const Mesh::BackgroundMesh<dim> &mesh,
    const Points::PointArrays<dim>  &points,
    const PointBlock<dim>           &block,
    Grid::NodalFields<dim>          &fields)
  {
    averaging->add_mass_and_momentum(mesh, points, block, fields);
  }

  template <int dim>
  void
  AutomaticAveraging<dim>::add_volumes(const Points::PointArrays<dim> &points,
                                       const PointBlock<dim>          &block,
                                       const Grid::NodalFields<dim>   &fields)
  {
    averaging->add_volumes(points, block, fields);
  }

  template <int dim>
  void
  AutomaticAveraging<dim>::add_stresses(const Points::PointArrays<dim> &points,
                                        const PointBlock<dim>          &block,
                                        Grid::NodalFields<dim>         &fields)
  {
    averaging->add_stresses(points, block, fields);
  }

  template <int dim>
  void
  AutomaticAveraging<dim>::find_weights(Grid::NodalFields<dim> &fields)
  {
    averaging->find_weights(fields);
  }

  template <int dim>
  const Filling<dim> *
  AutomaticAveraging<dim>::filling_of_nodes() const
  {
    return averaging->filling_of_nodes();
  }

  template <int dim>
  bool
  AutomaticAveraging<dim>::sets_forces() const
  {
    return averaging->sets_forces();
  }

  template <int dim>
  void
  AutomaticAveraging<dim>::find_forces(Grid::NodalFields<dim> &fields)
  {
    averaging->find_forces(fields);
  }

  template <int dim>
  void
  AutomaticAveraging<dim>::find_gradients(Grid::NodalFields<dim> &fields)
  {
    averaging->find_gradients(fields);
  }

  template <int dim>
  void
  AutomaticAveraging<dim>::evaluate(const Grid::NodalFields<dim>   &fields,
                                    const Points::PointArrays<dim> &points,
                                    PointBlock<dim>                &block) const
  {
    averaging->evaluate(fields, points, block);
  }

  template <int dim>
  double
  AutomaticAveraging<dim>::lost_power(
    const Grid::NodalFields<dim> &fields) const
  {
    return averaging->lost_power(fields);
  }

  template <int dim>
  void
  AutomaticAveraging<dim>::serialize(Core::Archive &archive)
  {
    averaging->serialize(archive);
  }

  template class AutomaticAveraging<2>;
  template class AutomaticAveraging<3>;

  namespace
  {
    const std::string documentation =
      "for granular laws 'cells', or 'nodes' if simplices that are filled at the "
      "start hold fewer than 3 points on average and there is no initial "
      "equilibrium; 'none' for elastic laws.";
    const AveragingRegistry<2>::Entry<AutomaticAveraging<2>>
      automatic_2d("automatic", documentation);
    const AveragingRegistry<3>::Entry<AutomaticAveraging<3>>
      automatic_3d("automatic", documentation);
  } // namespace
} // namespace mpm_granular::Transfer
