#include <deal.II/base/timer.h>

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
  MPMSolver<dim>::advance_one_step(const double    next_event,
                                   const Requests &requests)
  {
    times.begin();
    if (adaptation.is_active())
      adapt_mesh();
    const double dt =
      step_control.next_step(step_limits(), current_time, next_event); // (T25)

    fields.gather_nodes(!averaging.sets_forces()); // (T9)
    averaging.find_weights(fields);                // (T40)
    smooth_pressures();                            // (T29)
    boundary.update(fields, current_time, dt);
    boundary.add_tractions(fields, current_time);                // (T10)
    parameters.body_force.add_loads(fields, mesh, current_time); // (T10)
    const Momentum::StepInput<dim> step{dt,
                                        velocity_update.pic_factor(dt),
                                        parameters.body_force.gravity_at(
                                          current_time),
                                        boundary.constraints(),
                                        damping()};
    times.end(StepTimes::nodes);
    move_and_strain(step); // (T11) to (T24)
    since_filter += dt;
    finish_step(dt, next_event, requests);
    times.end(StepTimes::rest);
  }

  template <int dim>
  void
  MPMSolver<dim>::finish_step(const double    time_step,
                              const double    next_event,
                              const Requests &requests)
  {
    agree_on_state(requests);
    ++n_steps;
    last_time_step = time_step;
    displacement += time_step * step_limits().largest_speed;
    const double missed = next_event - current_time - time_step;
    current_time        = std::abs(missed) < 1e-12 * time_step ?
                            next_event :
                            current_time + time_step;
    keep_order();
    balance();
  }

  template <int dim>
  void
  MPMSolver<dim>::smooth_pressures()
  {
    if (scheme.filter_rate * since_filter < 1.)
      return;
    ledger.filter_loss +=
      sweep.smooth_pressures(points.arrays(), fields, since_filter);
    if (!averaging.sets_forces())
      fields.gather_forces();
    since_filter = 0.;
  }

  template <int dim>
  void
  MPMSolver<dim>::find_velocities(const Momentum::StepInput<dim> &step)
  {
    momentum.advance(fields, step); // (T12)
    velocity_update.find_motion({momentum.velocity_before(),
                                 momentum.velocity_after(),
                                 momentum.holding(step)},
                                step.time_step,
                                fields); // (T14)
    fields.extend_motion();
  }

  template <int dim>
  void
  MPMSolver<dim>::remap_velocity(const Momentum::StepInput<dim> &step)
  {
    velocity_update.add_momentum(fields, momentum.kept_momentum(step)); // (T16)
    momentum.remap_velocity(fields, step);
  }

  template <int dim>
  void
  MPMSolver<dim>::shift_positions(const Momentum::StepInput<dim> &step)
  {
    if (scheme.shift_rate == 0.)
      return;
    const Tensor<1, dim> moved =
      parameters.position_shift.add(mesh,
                                    partition,
                                    scheme.shift_rate,
                                    *averaging.filling_of_nodes(),
                                    cell_sizes,
                                    momentum.holding(step),
                                    step.time_step,
                                    fields); // (T69)
    fields.extend_motion();
    // What this takes from the potential energy is work of no force.
    ledger.transfer_loss += step.time_step * (step.gravity * moved);
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
        double dissipated = 0.;
        momentum.map_velocity(fields, step.constraints); // (T15)
        averaging.find_gradients(fields);                // (T42)
        times.end(StepTimes::momentum);
        on_this_rank(
          [&] { dissipated = sweep.strain(arrays, fields, step.time_step); });
        times.end(StepTimes::points);
        if (!averaging.sets_forces())
          fields.gather_forces();      // (T9)
        averaging.find_forces(fields); // (T41, T43)
        find_velocities(step);         // (T12, T14)
        count_lost_power(step.time_step);
        shift_positions(step);
        times.end(StepTimes::momentum);
        on_this_rank([&] {
          result = sweep.move(arrays, fields, step.time_step, step.pic_factor);
        });
        result.dissipated = dissipated;
      }
    else
      {
        averaging.find_forces(fields); // (T41, T43)
        find_velocities(step);         // (T12, T14)
        if (order == StressOrder::update_stress_last)
          momentum.strain_with_velocity(fields); // (T15)
        else
          remap_velocity(step);           // (T16)
        averaging.find_gradients(fields); // (T42)
        count_lost_power(step.time_step);
        shift_positions(step);
        times.end(StepTimes::momentum);
        on_this_rank([&] {
          result =
            sweep.advance(arrays, fields, step.time_step, step.pic_factor);
        });
      }
    times.end(StepTimes::points);
    update_ledger(step, result);
    times.end(StepTimes::ledger);
    on_this_rank([&] { check_points(result); });
    is_out_of_reach = result.relocation.is_out_of_reach;
    n_runs          = result.n_runs;
  }

  template <int dim>
  void
  MPMSolver<dim>::on_this_rank(const std::function<void()> &action)
  {
    if (!error.empty())
      return;
    try
      {
        action();
      }
    catch (const ComputationError &exception)
      {
        error = exception.what();
      }
  }

  template <int dim>
  void
  MPMSolver<dim>::count_lost_power(const double time_step)
  {
    ledger.transfer_loss += time_step * averaging.lost_power(fields); // (T28d)
  }

  template <int dim>
  Momentum::GridWork
  MPMSolver<dim>::update_ledger(const Momentum::StepInput<dim> &step,
                                const SweepResult              &sweep_result)
  {
    const Momentum::GridWork work = momentum.work(fields, step);
    ledger.dissipated += sweep_result.dissipated;
    ledger.boundary_work += work.boundary;
    ledger.damping -= work.damping;
    ledger.transfer_loss +=
      parameters.momentum.mass_scaling *
        (motion.kinetic_energy - sweep_result.motion.kinetic_energy) +
      work.total + work.straining_loss; // (T28)
    motion = sweep_result.motion;
    return work;
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
    const unsigned int lost_point = sweep_result.relocation.lost_point;
    if (lost_point == Transfer::no_point)
      return;
    if (!parameters.remove_lost_points)
      throw ComputationError(
        name(lost_point) +
        " has left the mesh. Make the mesh larger, close the boundary with a "
        "condition, or set Points/Remove lost points = true.");
    n_lost += points.remove_lost();
  }

  template <int dim>
  void
  MPMSolver<dim>::keep_order()
  {
    // Points that cross cells break runs up; ordering costs less than it gains
    // when there are this many more runs than in order (measured). All ranks
    // order at the same step, or each would wait for the others in turn.
    constexpr double too_many = 1.2;
    if (n_runs_in_order == 0)
      n_runs_in_order = agreement.n_runs;
    else if (agreement.n_runs > too_many * n_runs_in_order)
      {
        points.order();
        n_runs_in_order = 0;
      }
  }

  template <int dim>
  void
  MPMSolver<dim>::agree_on_state(const Requests &requests)
  {
    RankReport report;
    report.critical_step  = std::numeric_limits<double>::max();
    report.least_altitude = std::numeric_limits<double>::max();
    for (const unsigned int cell : fields.active_cells)
      {
        report.critical_step =
          std::min(report.critical_step, cell_limits[cell].critical_step);
        report.least_altitude =
          std::min(report.least_altitude, cell_limits[cell].altitude);
      }
    report.critical_step *= std::sqrt(parameters.momentum.mass_scaling);
    report.motion          = motion;
    report.n_points        = points.arrays().size();
    report.n_runs          = n_runs;
    report.is_out_of_reach = is_out_of_reach;
    report.requests        = requests;
    report.error           = error;
    agreement              = agree(report, partition.communicator);
  }

  template <int dim>
  void
  MPMSolver<dim>::balance()
  {
    // Sharing out costs some steps; where points are too few to be shared out
    // evenly it must not be tried all the time.
    constexpr unsigned int least_interval = 50;
    load.largest_imbalance =
      std::max(load.largest_imbalance, agreement.imbalance);
    const bool is_uneven = agreement.imbalance > partition.largest_imbalance &&
                           n_steps >= last_balance + least_interval;
    if (!is_uneven && !agreement.is_out_of_reach)
      return;
    const Timer timer;
    points.release();
    points.send_home();
    if (is_uneven)
      {
        // A part that has gained points goes on gaining, one that has lost
        // goes on losing: with so much less or more than its share, the parts
        // are even halfway to the next time, which is twice as far.
        constexpr double unit = 64.;
        const double     mean = double(agreement.n_points) / partition.n_ranks;
        const double     most = 1. + partition.largest_imbalance;
        redistribute(std::lround(
          unit * std::clamp(points.arrays().size() / mean, 1. / most, most)));
        last_balance = n_steps;
        ++load.n_redistributions;
      }
    else
      project();
    ++load.n_migrations;
    load.seconds += timer.wall_time();
  }

  template <int dim>
  void
  MPMSolver<dim>::redistribute(const std::uint32_t weight_of_point)
  {
    const auto weights = points.count_by_cell(weight_of_point);
    points.release();
    partition.distribute(weights);
    if (mesh.is_distributed())
      reinit_on_mesh();
    points.send_home();
    project();
  }

  template <int dim>
  void
  MPMSolver<dim>::reinit_on_mesh()
  {
    fields.reinit();
    boundary.reinit();
    momentum.reinit();
    averaging.reinit(mesh, partition, largest_specific_volumes());
    find_cell_limits();
    find_cell_sizes();
  }

  template <int dim>
  void
  MPMSolver<dim>::project()
  {
    const SweepResult result = sweep.project(points.arrays(), fields);
    motion                   = result.motion;
    n_runs                   = result.n_runs;
    n_runs_in_order          = 0;
  }

  template <int dim>
  Observables::Snapshot<dim>
  MPMSolver<dim>::snapshot() const
  {
    return {current_time,
            n_steps,
            last_time_step,
            n_lost,
            parameters.body_force.gravity_at(load_time()),
            points.arrays(),
            mesh,
            laws,
            ledger,
            partition.communicator,
            parameters.momentum.mass_scaling};
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
