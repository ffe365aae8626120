#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <mpm_granular/core/exact_text.h>
#include <mpm_granular/core/signals.h>
#include <mpm_granular/output/number_text.h>
#include <mpm_granular/solver/run.h>

#include <algorithm>
#include <limits>
#include <map>
#include <sstream>

namespace mpm_granular::Solver
{
  using namespace dealii;

  namespace
  {
    /// The output settings with the folder in place of its name.
    Output::OutputParameters
    in_folder(Output::OutputParameters parameters,
              const Output::RunFolder &folder)
    {
      parameters.directory = folder.path();
      return parameters;
    }

    /// The most memory that the processes had so far [bytes].
    double
    peak_memory(const MPI_Comm communicator)
    {
      Utilities::System::MemoryStats memory;
      Utilities::System::get_memory_stats(memory);
      constexpr double unit = 1024.;
      return unit * Utilities::MPI::sum(double(memory.VmHWM), communicator);
    }
  } // namespace

  template <int dim>
  Run<dim>::Run(RunParameters<dim> &parameters, const Parameters::RunInfo &info)
    : parameters(parameters)
    , info(info)
    , is_first_rank(Utilities::MPI::this_mpi_process(info.communicator) == 0)
    , solver(parameters, info.input_file, info.communicator)
    , folder(parameters.output.directory,
             info.overwrite || info.check_only || !info.checkpoint.empty())
    , console(is_first_rank)
    , points_output(in_folder(parameters.output, folder),
                    solver.material_laws(),
                    info.communicator)
    , grid_output(in_folder(parameters.output, folder), info.communicator)
    , manifest(info.command_line,
               Utilities::MPI::n_mpi_processes(info.communicator))
    , field_times(parameters.output.interval)
    , observable_times(parameters.output.observables_interval)
    , checkpoints(folder.path(),
                  parameters.checkpoint.n_kept,
                  info.communicator)
    , checkpoint_trigger(parameters.checkpoint, is_first_rank)
    , in_steps(timings.section("time steps"))
    , in_observables(timings.section("observables"))
    , in_fields(timings.section("output of fields"))
    , in_checkpoints(timings.section("checkpoints"))
  {
    manifest.set_up_time = since_start.wall_time();
  }

  template <int dim>
  Output::Preflight
  Run<dim>::preflight() const
  {
    const auto &mesh   = solver.background_mesh();
    const auto &arrays = solver.material_points().arrays();
    const auto &laws   = solver.material_laws();
    const auto &names  = parameters.materials.all_names();
    const auto &limits = solver.step_limits();
    const auto  summed = [&](const auto value) {
      return Utilities::MPI::sum(value, info.communicator);
    };

    Output::Preflight report;
    report.dimension      = dim;
    report.n_cells        = mesh.n_global_cells();
    report.n_nodes        = mesh.n_global_nodes();
    report.mean_cell_size = mesh.mean_cell_size();
    report.min_altitude   = limits.least_altitude;
    report.n_points       = solver.n_points();
    report.n_filled_cells =
      summed(std::uint64_t(solver.nodal_fields().active_cells.size()));

    const auto &scheme          = solver.chosen_scheme();
    report.averaging            = scheme.averaging;
    report.pressure_filter_rate = scheme.filter_rate;
    report.position_shift_rate  = scheme.shift_rate;

    report.mass = report.volume = 0.;
    std::vector<std::uint64_t>           n_of_material(laws.size(), 0);
    std::map<unsigned int, unsigned int> n_in_cell;
    for (unsigned int p = 0; p < arrays.size(); ++p)
      {
        report.mass += arrays.mass[p];
        report.volume += arrays.volume[p];
        ++n_of_material[arrays.material[p]];
        ++n_in_cell[arrays.cell[p]];
      }
    unsigned int fewest = std::numeric_limits<unsigned int>::max(), most = 0;
    for (const auto &[cell, n_points] : n_in_cell)
      {
        fewest = std::min(fewest, n_points);
        most   = std::max(most, n_points);
      }
    report.mass                = summed(report.mass);
    report.volume              = summed(report.volume);
    report.min_points_per_cell = Utilities::MPI::min(fewest, info.communicator);
    report.max_points_per_cell = Utilities::MPI::max(most, info.communicator);
    Utilities::MPI::sum(n_of_material, info.communicator, n_of_material);
    for (unsigned int m = 0; m < laws.size(); ++m)
      report.materials.push_back(
        {names[m],
         parameters.materials[names[m]].law.chosen_name(),
         laws[m]->density(),
         laws[m]->wave_speed(),
         n_of_material[m]});

    report.end_time        = parameters.end_time;
    report.stable_dt       = limits.critical_step;
    report.chosen_dt       = parameters.time_step.is_fixed() ?
                               parameters.time_step.fixed_step :
                               parameters.time_step.cfl * limits.critical_step;
    report.gravity         = parameters.body_force.gravity_at(0.).norm();
    report.n_files         = parameters.output.interval > 0. ?
                               parameters.end_time / parameters.output.interval + 1. :
                               2.;
    report.bytes_per_file  = points_output.estimated_file_size(report.n_points);
    report.bytes_in_memory = summed(double(solver.memory_consumption()));
    report.n_ranks         = Utilities::MPI::n_mpi_processes(info.communicator);
    // Measured for the shipped walls in Release on one core.
    report.throughput = dim == 2 ? 24. : 14.;
    for (const auto &warnings :
         Utilities::MPI::all_gather(info.communicator, solver.warnings()))
      if (report.warnings.empty())
        report.warnings = warnings; // one place is enough
    report.add_warnings();
    return report;
  }

  template <int dim>
  Outcome
  Run<dim>::execute()
  {
    const auto report    = preflight();
    const bool continues = !info.checkpoint.empty();
    manifest.dimension   = dim;
    manifest.n_cells     = report.n_cells;
    manifest.n_nodes     = report.n_nodes;
    manifest.n_points    = report.n_points;
    manifest.warnings    = report.warnings;
    if (continues)
      restore();
    if (!info.check_only)
      continues ? reopen_output() : open_output();
    console.say(report.text());
    for (const auto &remark : info.remarks)
      console.say(remark);
    if (continues)
      console.say(manifest.resumed.back());
    if (info.check_only)
      return Outcome::finished;

    try
      {
        const Outcome outcome = compute();
        close_output(outcome == Outcome::finished ?
                       Output::Manifest::Outcome::done :
                       Output::Manifest::Outcome::interrupted,
                     outcome == Outcome::finished ? "" : "stopped by a signal");
        return outcome;
      }
    catch (const ComputationError &error)
      {
        std::ostringstream message;
        message << "The computation failed at time " << solver.time()
                << " s (step " << solver.step() << "): " << error.what();
        close_output(Output::Manifest::Outcome::failed, message.str());
        throw ComputationError(message.str());
      }
  }

  template <int dim>
  void
  Run<dim>::open_output()
  {
    Output::on_first_rank(info.communicator, [&] {
      folder.prepare();
      console.open_log(folder.file("log.txt"));
      write_parameters();
      parameters.observables.open(folder.file("observables.csv"));
      manifest.write(folder.file("manifest.json"));
    });
  }

  template <int dim>
  void
  Run<dim>::write_parameters() const
  {
    Output::write_atomically(folder.file("parameters.prm"),
                             [&](std::ostream &file) {
                               file << info.parameter_text;
                             });
  }

  template <int dim>
  double
  Run<dim>::next_event() const
  {
    return std::min(
      {parameters.end_time, field_times.next(), observable_times.next()});
  }

  template <int dim>
  Outcome
  Run<dim>::compute()
  {
    const bool starts  = info.checkpoint.empty() || solver.is_settling();
    Outcome    outcome = solver.is_settling() ? settle() : Outcome::finished;
    if (outcome == Outcome::finished)
      {
        if (starts)
          {
            write_observables();
            write_fields();
          }
        outcome = take_steps();
      }
    // Before the last output, which the run has only because it ends here.
    if ((outcome == Outcome::interrupted || parameters.checkpoint.at_end) &&
        checkpoint_step != solver.step())
      write_checkpoint();
    return outcome;
  }

  template <int dim>
  Outcome
  Run<dim>::settle()
  {
    const auto      &equilibrium = parameters.equilibrium;
    const double     start       = -equilibrium.maximum_time;
    Output::Progress progress(console,
                              start,
                              0.,
                              parameters.output.progress_interval);
    Output::Schedule rows(parameters.output.observables_interval, start);
    rows.passes(solver.time());
    if (info.checkpoint.empty())
      write_observables();
    while (!equilibrium.is_reached(solver.last_unrest()))
      {
        if (!solver.is_settling())
          throw ComputationError(
            "No initial equilibrium within 'Initial equilibrium/Maximum time' "
            "= " +
            Core::exact_text(equilibrium.maximum_time) +
            " s: " + solver.last_unrest().text() +
            ". Is the body stable? Otherwise try a longer time or larger "
            "tolerances.");
        if (solver.requests().stop)
          return Outcome::interrupted;
        {
          Output::Timings::Scope timer(timings, in_steps);
          solver.settle_one_step(std::min(0., rows.next()), requests_now());
        }
        finish_step(progress, rows);
      }
    if (last_row != solver.time())
      write_observables();
    console.say("Initial equilibrium after " +
                Output::count_text(solver.step()) + " steps, " +
                Output::short_text(solver.time() - start) +
                " s: " + solver.last_unrest().text() + ".");
    solver.start_from_rest();
    checkpoint_trigger.start(solver.time());
    return Outcome::finished;
  }

  template <int dim>
  Outcome
  Run<dim>::take_steps()
  {
    Output::Progress progress(console,
                              std::max(before.time, 0.),
                              parameters.end_time,
                              parameters.output.progress_interval);
    while (solver.time() < parameters.end_time)
      {
        // Signals may reach the ranks at different steps.
        if (solver.requests().stop)
          return Outcome::interrupted;
        {
          Output::Timings::Scope timer(timings, in_steps);
          solver.advance_one_step(next_event(), requests_now());
        }
        if (field_times.passes(solver.time()))
          write_fields();
        finish_step(progress, observable_times);
      }
    return Outcome::finished;
  }

  template <int dim>
  Requests
  Run<dim>::requests_now() const
  {
    return {Core::stop_requested(), checkpoint_trigger.is_asked_for()};
  }

  template <int dim>
  void
  Run<dim>::finish_step(Output::Progress &progress, Output::Schedule &rows)
  {
    n_point_steps += solver.n_points();
    if (parameters.output.observables_interval == 0. ||
        rows.passes(solver.time()))
      write_observables();
    if (checkpoint_trigger.is_due(solver.step(),
                                  solver.time(),
                                  solver.requests().checkpoint))
      write_checkpoint();
    if (is_first_rank && progress.is_due())
      progress.report({solver.time(),
                       solver.time_step(),
                       solver.step(),
                       n_point_steps,
                       solver.kinetic_energy()});
  }

  template <int dim>
  void
  Run<dim>::write_observables()
  {
    Output::Timings::Scope timer(timings, in_observables);
    last_row = solver.time();
    parameters.observables.write(solver.snapshot());
  }

  template <int dim>
  void
  Run<dim>::write_fields()
  {
    Output::Timings::Scope timer(timings, in_fields);
    last_written = solver.time();
    points_output.write(solver.time(),
                        solver.step(),
                        solver.material_points().arrays());
    if (!parameters.output.write_grid)
      return;
    // Mass, velocity and pressure of all nodes, each from one of the ranks that
    // know it. They follow from the points alone, also in a run that is
    // continued.
    solver.gather_nodes();
    const auto         &fields   = solver.nodal_fields();
    const auto          pressure = solver.nodal_pressure();
    constexpr int       n_values = 2 + dim;
    std::vector<double> values(solver.background_mesh().n_nodes() * n_values,
                               0.);
    for (unsigned int slot = 0; slot < fields.n_active_nodes(); ++slot)
      if (fields.shared.counts(slot))
        {
          double *of_node = &values[fields.active_nodes[slot] * n_values];
          of_node[0]      = fields.sums[slot].mass;
          for (unsigned int d = 0; d < dim; ++d)
            of_node[1 + d] =
              fields.sums[slot].momentum[d] / fields.sums[slot].mass;
          of_node[1 + dim] = pressure[slot];
        }
    solver.spread_to_own_cells(values, n_values);
    solver.background_mesh().interpolate_to_hanging_nodes(values, n_values);
    grid_output.write(solver.time(),
                      solver.step(),
                      solver.background_mesh(),
                      solver.cell_partition(),
                      {{"mass",
                        "kg",
                        1,
                        [&](const auto node, const auto) {
                          return values[node * n_values];
                        }},
                       {"velocity",
                        "m/s",
                        dim,
                        [&](const auto node, const auto component) {
                          return values[node * n_values + 1 + component];
                        }},
                       {"pressure", "Pa", 1, [&](const auto node, const auto) {
                          return values[node * n_values + 1 + dim];
                        }}});
  }

  template <int dim>
  void
  Run<dim>::close_output(const Output::Manifest::Outcome outcome,
                         const std::string              &message)
  {
    if (last_row != solver.time())
      write_observables();
    if (last_written != solver.time())
      write_fields();
    const std::string profile =
      parameters.observables.profile_text(solver.snapshot());
    const double bytes =
      Utilities::MPI::sum(double(solver.material_points().memory_consumption()),
                          info.communicator);
    const Output::Summary summary{std::max(solver.time(), 0.) -
                                    std::max(before.time, 0.),
                                  unsigned(solver.step() - before.n_steps),
                                  n_point_steps,
                                  timings.seconds(in_steps),
                                  bytes / solver.n_points()};
    manifest.n_lost_points =
      Utilities::MPI::sum(std::uint64_t(solver.n_lost_points()),
                          info.communicator);
    manifest.n_steps            = solver.step();
    manifest.n_point_steps      = before.n_point_steps + n_point_steps;
    manifest.n_files            = points_output.n_files();
    manifest.simulated_time     = solver.time();
    manifest.loop_time          = before.loop_time + summary.loop_time;
    manifest.throughput         = Output::throughput(summary);
    manifest.bytes_per_point    = summary.bytes_per_point;
    manifest.peak_memory        = peak_memory(info.communicator);
    const auto &load            = solver.load_balance();
    manifest.n_redistributions  = load.n_redistributions;
    manifest.largest_imbalance  = load.largest_imbalance;
    const auto &changes         = solver.mesh_changes();
    manifest.n_adaptations      = changes.n_adaptations;
    manifest.adaptation_time    = changes.seconds;
    manifest.n_cells            = solver.background_mesh().n_global_cells();
    manifest.n_nodes            = solver.background_mesh().n_global_nodes();
    const auto          sent    = solver.nodal_fields().traffic();
    const std::uint64_t n_steps = solver.step() - before.n_steps;
    if (n_steps > 0)
      {
        manifest.messages_per_step =
          Utilities::MPI::max(double(sent.n_messages), info.communicator) /
          n_steps;
        manifest.bytes_sent_per_step =
          Utilities::MPI::max(double(sent.n_bytes), info.communicator) /
          n_steps;
      }
    manifest.end(outcome, message);
    Output::on_first_rank(info.communicator, [&] {
      Output::write_atomically(folder.file("profile.csv"),
                               [&](std::ostream &file) { file << profile; });
      manifest.write(folder.file("manifest.json"));
    });

    console.say(Output::summary_text(summary));
    if (Utilities::MPI::n_mpi_processes(info.communicator) > 1)
      console.say("Load balance: points moved " +
                  Output::count_text(load.n_migrations) +
                  " times, cells shared out anew " +
                  Output::count_text(load.n_redistributions) + " times, in " +
                  Output::duration_text(load.seconds) +
                  "; the process with the most points had up to " +
                  Output::short_text(100. * load.largest_imbalance) +
                  " % more than the mean.");
    if (parameters.adaptation.is_wanted())
      console.say("Adaptive mesh: changed " +
                  Output::count_text(changes.n_adaptations) + " times, in " +
                  Output::duration_text(changes.seconds) + "; it has " +
                  Output::count_text(manifest.n_cells) + " cells." +
                  (changes.n_limited == 0 ?
                     "" :
                     " 'Maximum number of cells' kept it coarser than the "
                     "criteria ask for " +
                       Output::count_text(changes.n_limited) + " times."));
    console.say("Results in " + folder.path());
  }

  template class Run<2>;
  template class Run<3>;
} // namespace mpm_granular::Solver
