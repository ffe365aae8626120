#include <mpm_granular/solver/sweep.h>

#include <algorithm>

namespace mpm_granular::Solver
{
  using namespace dealii;

  template <int dim>
  Sweep<dim>::Sweep(
    const Mesh::BackgroundMesh<dim>                            &mesh,
    const Mesh::Partition<dim>                                 &partition,
    const std::vector<const Materials::ConstitutiveLaw<dim> *> &laws,
    Transfer::Averaging<dim>                                   &averaging,
    const Transfer::VelocityUpdate<dim>                        &velocity_update,
    const Transfer::SettledPressures<dim> &settled_pressures)
    : mesh(mesh)
    , partition(partition)
    , laws(laws)
    , averaging(averaging)
    , velocity_update(velocity_update)
    , settled_pressures(settled_pressures)
    , filter(mesh)
  {}

  template <int dim>
  template <class Action>
  void
  Sweep<dim>::for_each_block(Points::PointArrays<dim> &points, Action &&action)
  {
    for (unsigned int next = 0; next < points.size(); next = block.end)
      {
        block.reinit(points, next);
        action();
      }
  }

  template <int dim>
  void
  Sweep<dim>::clear(Grid::NodalFields<dim> &fields)
  {
    fields.clear_cells();
    averaging.clear();
  }

  template <int dim>
  void
  Sweep<dim>::clear_stresses(Grid::NodalFields<dim> &fields)
  {
    fields.clear_stresses();
    averaging.clear_stresses();
  }

  template <int dim>
  void
  Sweep<dim>::relocate_and_sum(Points::PointArrays<dim> &points,
                               Grid::NodalFields<dim>   &fields,
                               SweepResult              &result)
  {
    result.relocation += Transfer::relocate(mesh, partition, points, block);
    averaging.add_mass_and_momentum(mesh, points, block, fields);
    velocity_update.give(mesh, points, block, fields);
    averaging.add_volumes(points, block, fields);
    result.motion += Points::motion_of(points, block.begin, block.end);
    result.n_runs += block.runs.size();
  }

  template <int dim>
  void
  Sweep<dim>::find_shape_values(Points::PointArrays<dim> &points)
  {
    Transfer::find_shape_values(mesh, points, block);
    Transfer::relocate(mesh, partition, points, block);
  }

  template <int dim>
  template <class Action>
  void
  Sweep<dim>::for_each_law(const Points::PointArrays<dim> &points,
                           const std::vector<Points::Run> &runs,
                           Action                        &&action)
  {
    const unsigned int n_runs = runs.size();
    for (unsigned int first = 0, last = 0; first < n_runs; first = last)
      {
        const unsigned int material = points.material[runs[first].begin];
        while (last < n_runs && points.material[runs[last].begin] == material)
          ++last;
        action(*laws[material], first, last);
      }
  }

  template <int dim>
  double
  Sweep<dim>::update_stresses(Points::PointArrays<dim> &points,
                              const double              time_step)
  {
    double      dissipated = 0.;
    const auto &strained   = block.strained;
    const auto &gradients  = block.gradients;
    for_each_law(points,
                 strained,
                 [&](const auto &law, const auto first, const auto last) {
                   dissipated += Materials::update_stress(
                     law,
                     points,
                     make_array_view(strained.cbegin() + first,
                                     strained.cbegin() + last),
                     make_array_view(gradients.cbegin() + first,
                                     gradients.cbegin() + last),
                     time_step);
                 });
    return dissipated;
  }

  template <int dim>
  SweepResult
  Sweep<dim>::project(Points::PointArrays<dim> &points,
                      Grid::NodalFields<dim>   &fields)
  {
    SweepResult result;
    clear(fields);
    for_each_block(points, [&] {
      Transfer::find_shape_values(mesh, points, block);
      relocate_and_sum(points, fields, result);
      averaging.add_stresses(points, block, fields);
    });
    return result;
  }

  template <int dim>
  SweepResult
  Sweep<dim>::advance(Points::PointArrays<dim> &points,
                      Grid::NodalFields<dim>   &fields,
                      const double              time_step,
                      const double              pic_factor)
  {
    SweepResult result;
    clear(fields);
    for_each_block(points, [&] {
      averaging.evaluate(fields, points, block);
      velocity_update.take(block, points);
      averaging.move_points(mesh, fields, block, time_step, pic_factor, points);
      result.dissipated += update_stresses(points, time_step);
      relocate_and_sum(points, fields, result);
      averaging.add_stresses(points, block, fields);
    });
    return result;
  }

  template <int dim>
  double
  Sweep<dim>::strain(Points::PointArrays<dim> &points,
                     Grid::NodalFields<dim>   &fields,
                     const double              time_step)
  {
    double dissipated = 0.;
    clear_stresses(fields);
    for_each_block(points, [&] {
      averaging.evaluate(fields, points, block);
      dissipated += update_stresses(points, time_step);
      find_shape_values(points);
      averaging.add_stresses(points, block, fields);
    });
    return dissipated;
  }

  template <int dim>
  SweepResult
  Sweep<dim>::move(Points::PointArrays<dim> &points,
                   Grid::NodalFields<dim>   &fields,
                   const double              time_step,
                   const double              pic_factor)
  {
    SweepResult result;
    clear(fields);
    for_each_block(points, [&] {
      averaging.move_points(mesh, fields, block, time_step, pic_factor, points);
      relocate_and_sum(points, fields, result);
    });
    return result;
  }

  template <int dim>
  void
  Sweep<dim>::sum_pressures(Points::PointArrays<dim> &points,
                            Grid::NodalFields<dim>   &fields)
  {
    filter.reinit(fields);
    for_each_block(points, [&] {
      find_shape_values(points);
      for (const auto &run : block.runs)
        if (laws[points.material[run.begin]]->has_smoothable_pressure())
          filter.add(fields, points, block, run);
    });
    filter.find_gradients(fields);
  }

  template <int dim>
  double
  Sweep<dim>::smooth_pressures(Points::PointArrays<dim> &points,
                               Grid::NodalFields<dim>   &fields,
                               const double              time)
  {
    sum_pressures(points, fields);
    double released_energy = 0.;
    clear_stresses(fields);
    for_each_block(points, [&] {
      find_shape_values(points);
      filter.evaluate(fields, points, block, smooth_pressure);
      settled_pressures.add(points, block, time, smooth_pressure);
      for_each_law(points,
                   block.runs,
                   [&](const auto &law, const auto first, const auto last) {
                     const Points::Run range{block.runs[first].begin,
                                             block.runs[last - 1].end};
                     released_energy +=
                       law.replace_pressure(points,
                                            range,
                                            smooth_pressure.data() +
                                              (range.begin - block.begin));
                   });
      averaging.add_stresses(points, block, fields);
    });
    return released_energy;
  }

  template <int dim>
  void
  Sweep<dim>::settle_pressures(Points::PointArrays<dim> &points,
                               Grid::NodalFields<dim>   &fields)
  {
    sum_pressures(points, fields);
    for_each_block(points, [&] {
      find_shape_values(points);
      filter.evaluate(fields, points, block, smooth_pressure);
      settled_pressures.keep(points, block, smooth_pressure);
    });
  }

  template class Sweep<2>;
  template class Sweep<3>;
} // namespace mpm_granular::Solver
