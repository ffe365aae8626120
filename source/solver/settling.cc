// The stage before time 0 that finds the initial equilibrium (T35).

#include <deal.II/base/mpi.h>

#include <mpm_granular/observables/energies.h>
#include <mpm_granular/solver/mpm_solver.h>

#include <algorithm>
#include <vector>

namespace mpm_granular::Solver
{
  using namespace dealii;

  template <int dim>
  void
  MPMSolver<dim>::prepare_settling()
  {
    current_time = -parameters.equilibrium.maximum_time;

    // Where a point lies on a face the smallest motion changes its gradients,
    // and no balance lasts. Drawn towards the centres of their cells all the
    // same part of the way, points still integrate what is linear.
    constexpr double part   = 1e-3;
    auto            &arrays = points.arrays();
    for (unsigned int p = 0; p < arrays.size(); ++p)
      {
        const auto     nodes = mesh.nodes(arrays.cell[p]);
        Tensor<1, dim> center;
        for (const unsigned int node : nodes)
          center += mesh.node_position(node);
        center /= double(nodes.size());
        for (unsigned int d = 0; d < dim; ++d)
          arrays.position[d][p] += part * (center[d] - arrays.position[d][p]);
      }
  }

  template <int dim>
  void
  MPMSolver<dim>::settle_one_step(const double    next_event,
                                  const Requests &requests)
  {
    const double dt =
      step_control.next_step(step_limits(), current_time, next_event); // (T25)

    fields.gather_nodes();          // (T9)
    averaging.find_weights(fields); // (T40)
    boundary.update_at_rest(fields);
    boundary.add_tractions(fields, load_time());                // (T10)
    parameters.body_force.add_loads(fields, mesh, load_time()); // (T10)
    const Momentum::StepInput<dim> step{dt,
                                        velocity_update.pic_factor(dt),
                                        parameters.body_force.gravity_at(
                                          load_time()),
                                        boundary.constraints(),
                                        &parameters.equilibrium.damping};
    strain_in_place(step);
    finish_step(dt, next_event, requests);
  }

  template <int dim>
  void
  MPMSolver<dim>::strain_in_place(const Momentum::StepInput<dim> &step)
  {
    auto &arrays = points.arrays();
    averaging.find_forces(fields);    // (T41, T43)
    find_velocities(step);            // (T12, T14)
    remap_velocity(step);             // (T16)
    averaging.find_gradients(fields); // (T42)
    count_lost_power(step.time_step);
    measure_unrest(step);

    SweepResult result;
    const auto  volumes = arrays.volume;
    on_this_rank([&] {
      result            = sweep.move(arrays, fields, 0., step.pic_factor);
      result.dissipated = sweep.strain(arrays, fields, step.time_step);
    });
    arrays.volume = volumes;
    // Weights work, but points that stay have the same potential energy.
    ledger.boundary_work += update_ledger(step, result).weight;
    on_this_rank([&] { check_points(result); });
    is_out_of_reach = result.relocation.is_out_of_reach;
    n_runs          = result.n_runs;
  }

  template <int dim>
  void
  MPMSolver<dim>::measure_unrest(const Momentum::StepInput<dim> &step)
  {
    // It takes a sum over the ranks.
    constexpr unsigned int interval = 20;
    if (n_steps % interval != 0)
      return;
    const auto   here    = momentum.force_balance(fields, step);
    const double elastic = Observables::elastic_energy(points.arrays(), laws);
    std::vector<double> sums{here.rest, here.external, here.internal, elastic};
    Utilities::MPI::sum(sums, partition.communicator, sums);
    const double kinetic = kinetic_energy();
    unrest.force_ratio =
      Momentum::ForceBalance{sums[0], sums[1], sums[2]}.ratio();
    unrest.energy_ratio = kinetic == 0. ? 0. : kinetic / sums[3];
  }

  template <int dim>
  void
  MPMSolver<dim>::start_from_rest()
  {
    auto &arrays = points.arrays();
    for (auto &component : arrays.velocity)
      std::fill(component.begin(), component.end(), 0.);
    for (unsigned int p = 0; p < arrays.size(); ++p)
      {
        laws[arrays.material[p]]->initialize(arrays, {p, p + 1});
        velocity_update.initialize(arrays, p, {});
      }
    ledger       = {};
    current_time = 0.;
    fields.gather_nodes(); // (T9)
    sweep.settle_pressures(arrays, fields);
    project();
    agree_on_state();
  }

  template class MPMSolver<2>;
  template class MPMSolver<3>;
} // namespace mpm_granular::Solver
