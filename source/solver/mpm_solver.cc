#include <mpm_granular/solver/mpm_solver.h>
#include <mpm_granular/time/critical_step.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace mpm_granular::Solver
{
  using namespace dealii;

  template <int dim>
  void
  MPMSolver<dim>::advance_one_step(const double next_event)
  {
    const double dt =
      step_control.next_step(step_limits(), current_time, next_event); // (T25)

    fields.gather_nodes(); // (T9)
    smooth_pressures();    // (T29)
    boundary.update(fields, current_time, dt);
    boundary.add_tractions(fields, current_time); // (T10)
    const Momentum::StepInput<dim> step{dt,
                                        parameters.transfer.pic_factor(dt),
                                        parameters.body_force.value(
                                          current_time),
                                        boundary.constraints()};
    move_and_strain(step); // (T11) to (T24)

    ++n_steps;
    since_filter += dt;
    last_time_step = dt;
    current_time   = std::abs(next_event - current_time - dt) < 1e-12 * dt ?
                       next_event :
                       current_time + dt;
  }

  template <int dim>
  void
  MPMSolver<dim>::smooth_pressures()
  {
    // Noise grows over many steps; filtering every tenth costs little.
    constexpr unsigned int interval = 10;
    if (!parameters.transfer.filters_pressure() || n_steps % interval != 0 ||
        since_filter == 0.)
      return;
    ledger.filter_loss +=
      sweep.smooth_pressures(points.arrays(),
                             fields,
                             parameters.transfer.filter_fraction(since_filter));
    fields.gather_forces();
    since_filter = 0.;
  }

  template <int dim>
  void
  MPMSolver<dim>::move_and_strain(const Momentum::StepInput<dim> &step)
  {
    using Transfer::StressOrder;
    const auto  order  = parameters.transfer.stress_order();
    auto       &arrays = points.arrays();
    SweepResult result;

    if (order == StressOrder::update_stress_first)
      {
        momentum.map_velocity(fields, step.constraints); // (T15)
        const double dissipated = sweep.strain(arrays, fields, step.time_step);
        fields.gather_forces();         // (T9)
        momentum.advance(fields, step); // (T12)
        result = sweep.move(arrays, fields, step.time_step, step.pic_factor);
        result.dissipated = dissipated;
      }
    else
      {
        momentum.advance(fields, step); // (T12)
        if (order == StressOrder::update_stress_last)
          momentum.strain_with_velocity(fields); // (T15)
        else
          momentum.remap_velocity(fields, step); // (T16)
        result = sweep.advance(arrays, fields, step.time_step, step.pic_factor);
      }
    update_ledger(step, result);
    check_points(result);
    keep_order(result);
  }

  template <int dim>
  void
  MPMSolver<dim>::update_ledger(const Momentum::StepInput<dim> &step,
                                const SweepResult              &sweep_result)
  {
    const Momentum::GridWork work = momentum.work(fields, step);
    ledger.dissipated += sweep_result.dissipated;
    ledger.boundary_work += work.boundary;
    ledger.transfer_loss += motion.kinetic_energy + work.total -
                            sweep_result.motion.kinetic_energy +
                            work.straining_loss; // (T28)
    motion = sweep_result.motion;
  }

  template <int dim>
  void
  MPMSolver<dim>::check_points(const SweepResult &sweep_result)
  {
    const auto &arrays = points.arrays();
    const auto  name   = [&](const unsigned int p) {
      return "Point " + std::to_string(arrays.id[p]) + " at " +
             Mesh::as_text(arrays.location(p));
    };
    if (!std::isfinite(sweep_result.motion.kinetic_energy))
      for (unsigned int p = 0; p < arrays.size(); ++p)
        {
          double sum = arrays.volume[p];
          for (unsigned int d = 0; d < dim; ++d)
            sum += arrays.position[d][p] + arrays.velocity[d][p];
          for (const auto &component : arrays.stress)
            sum += component[p];
          if (!std::isfinite(sum))
            throw ComputationError(
              name(p) + " has a value that is not a number. Try a smaller CFL "
                        "or more points per cell.");
        }
    if (sweep_result.lost_point == Transfer::no_point)
      return;
    if (!parameters.remove_lost_points)
      throw ComputationError(
        name(sweep_result.lost_point) +
        " has left the mesh. Make the mesh larger, close the boundary with a "
        "condition, or set Points/Remove lost points = true.");
    n_lost += points.remove_lost();
    if (points.arrays().size() == 0)
      throw ComputationError("All points have left the mesh.");
  }

  template <int dim>
  void
  MPMSolver<dim>::keep_order(const SweepResult &sweep_result)
  {
    // Points that cross cells break runs up; ordering costs less than it gains
    // when there are this many more runs than in order (measured).
    constexpr double too_many = 1.2;
    if (n_runs_in_order == 0)
      n_runs_in_order = sweep_result.n_runs;
    else if (sweep_result.n_runs > too_many * n_runs_in_order)
      {
        points.order();
        n_runs_in_order = 0;
      }
  }

  template <int dim>
  Time::StepLimits
  MPMSolver<dim>::step_limits() const
  {
    Time::StepLimits limits{std::numeric_limits<double>::max(),
                            std::numeric_limits<double>::max(),
                            std::sqrt(motion.speed_squared)};
    for (const unsigned int cell : fields.active_cells)
      {
        limits.critical_step =
          std::min(limits.critical_step, cell_limits[cell].critical_step);
        limits.least_altitude =
          std::min(limits.least_altitude, cell_limits[cell].altitude);
      }
    return limits;
  }

  template <int dim>
  Observables::Snapshot<dim>
  MPMSolver<dim>::snapshot() const
  {
    return {current_time,
            n_steps,
            last_time_step,
            n_lost,
            parameters.body_force.value(current_time),
            points.arrays(),
            mesh,
            laws,
            ledger};
  }

  template <int dim>
  std::size_t
  MPMSolver<dim>::memory_consumption() const
  {
    return points.memory_consumption() + fields.memory_consumption() +
           mesh.memory_consumption() +
           cell_limits.capacity() * sizeof(cell_limits[0]);
  }

  template class MPMSolver<2>;
  template class MPMSolver<3>;
} // namespace mpm_granular::Solver
