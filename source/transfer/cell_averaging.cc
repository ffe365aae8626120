#include <mpm_granular/transfer/cell_averaging.h>
#include <mpm_granular/transfer/grid_to_points.h>
#include <mpm_granular/transfer/points_to_grid.h>
#include <mpm_granular/transfer/stress_power.h>

#include <type_traits>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  void
  CellAveraging<dim>::add_parameters(ParameterHandler &)
  {}

  template <int dim>
  void
  CellAveraging<dim>::reinit(const Mesh::BackgroundMesh<dim> &new_mesh,
                             const Mesh::Partition<dim>      &partition,
                             const std::vector<double> &largest_specific_volume)
  {
    mesh = &new_mesh;
    filling.reinit(*mesh, partition, largest_specific_volume);
  }

  template <int dim>
  void
  CellAveraging<dim>::clear()
  {
    filling.clear();
  }

  template <int dim>
  void
  CellAveraging<dim>::add_volumes(const Points::PointArrays<dim> &points,
                                  const PointBlock<dim>          &block,
                                  const Grid::NodalFields<dim>   &fields)
  {
    filling.add(points, block, fields);
  }

  template <int dim>
  void
  CellAveraging<dim>::add_stresses(const Points::PointArrays<dim> &points,
                                   const PointBlock<dim>          &block,
                                   Grid::NodalFields<dim>         &fields)
  {
    add_stress(*mesh, points, block, fields);
  }

  template <int dim>
  void
  CellAveraging<dim>::find_weights(Grid::NodalFields<dim> &fields)
  {
    filling.sum(fields);
  }

  template <int dim>
  void
  CellAveraging<dim>::find_forces(Grid::NodalFields<dim> &fields)
  {
    factors.assign(fields.active_cells.size(), 1.);
    const auto is_full = filling.full_nodes(fields);
    mesh->visit([&](const auto &cells) {
      using Cell   = typename std::decay_t<decltype(cells)>::value_type;
      auto &active = fields.template cells<Cell>();
      for (unsigned int c = 0; c < factors.size(); ++c)
        {
          const auto  &nodes    = active.nodes[c];
          const double volume   = filling.of_cell(c);
          bool         all_full = true;
          for (const unsigned int node : nodes)
            all_full &= is_full[node] != 0;
          if (volume == 0. || !all_full)
            continue;
          factors[c] = mesh->cell_volume(fields.active_cells[c]) / volume;
          active.sums[c].internal *= factors[c];
        }
    });
    fields.gather_forces();
  }

  template <int dim>
  void
  CellAveraging<dim>::evaluate(const Grid::NodalFields<dim>   &fields,
                               const Points::PointArrays<dim> &points,
                               PointBlock<dim>                &block) const
  {
    evaluate_gradients(*mesh, fields, points, block);
  }

  template <int dim>
  double
  CellAveraging<dim>::lost_power(const Grid::NodalFields<dim> &fields) const
  {
    double power = 0.;
    mesh->visit([&](const auto &cells) {
      using Cell         = typename std::decay_t<decltype(cells)>::value_type;
      const auto &active = fields.template cells<Cell>();
      for (unsigned int c = 0; c < factors.size(); ++c)
        if (factors[c] != 1.)
          power +=
            (1. - 1. / factors[c]) * stress_power(active.sums[c].internal,
                                                  cells[fields.active_cells[c]],
                                                  active.nodes[c],
                                                  fields);
    });
    return power;
  }

  template <int dim>
  void
  CellAveraging<dim>::serialize(Core::Archive &archive)
  {
    filling.serialize(archive);
  }

  template class CellAveraging<2>;
  template class CellAveraging<3>;

  namespace
  {
    const std::string documentation =
      "in filled surroundings the mean stress of a cell's points acts on the "
      "whole cell, which makes less noise where points cross cells.";
    const AveragingRegistry<2>::Entry<CellAveraging<2>> cells_2d("cells",
                                                                 documentation);
    const AveragingRegistry<3>::Entry<CellAveraging<3>> cells_3d("cells",
                                                                 documentation);
  } // namespace
} // namespace mpm_granular::Transfer
