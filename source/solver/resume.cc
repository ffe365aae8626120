#include <mpm_granular/checkpoint/checkpoint_file.h>
#include <mpm_granular/core/exact_text.h>
#include <mpm_granular/core/synchronize.h>
#include <mpm_granular/solver/run.h>

#include <filesystem>
#include <sstream>

/*
 * The part of Run that writes checkpoints and continues from them.
 */
namespace mpm_granular::Solver
{
  template <int dim>
  void
  Run<dim>::write_checkpoint()
  {
    Output::Timings::Scope timer(timings, in_checkpoints);
    // A checkpoint counts on the rows that are in the table.
    if (is_first_rank)
      Core::synchronize(folder.file("observables.csv"));
    checkpoints.write(solver.step(),
                      [this](Core::Archive &archive) { serialize(archive); });
    checkpoint_step = solver.step();
    console.log("Checkpoint at step " + std::to_string(solver.step()));
  }

  template <int dim>
  void
  Run<dim>::serialize(Core::Archive &archive)
  {
    if (!archive.is_reading())
      {
        // Read before there is a run.
        std::string parameter_text = info.parameter_text;
        std::string input_file =
          std::filesystem::absolute(info.input_file).string();
        Checkpoint::serialize_input(archive, parameter_text, input_file);
      }
    solver.serialize(archive);
    parameters.observables.serialize(archive);
    points_output.serialize(archive);
    grid_output.serialize(archive);
    archive.replicated("output/last_written", last_written);
    archive.replicated("output/last_row", last_row);

    Before now{solver.time(),
               solver.step(),
               before.n_point_steps + n_point_steps,
               before.loop_time + timings.seconds(in_steps)};
    archive.replicated("run/n_point_steps", now.n_point_steps);
    archive.replicated("run/loop_time", now.loop_time);
    std::string resumed;
    for (const auto &start : manifest.resumed)
      resumed += start + "\n";
    archive.replicated("run/resumed", resumed);
    if (!archive.is_reading())
      return;
    before = now;
    std::istringstream starts(resumed);
    for (std::string start; std::getline(starts, start);)
      manifest.resumed.push_back(start);
  }

  template <int dim>
  void
  Run<dim>::restore()
  {
    try
      {
        Checkpoint::Reader reader(info.checkpoint, info.communicator);
        serialize(reader);
      }
    catch (const InputError &error)
      {
        throw InputError("--resume from '" + info.checkpoint +
                         "': " + error.what());
      }
    require(parameters.end_time >= solver.time(),
            "End time = " + Core::exact_text(parameters.end_time) +
              " s is before the time of the checkpoint '" + info.checkpoint +
              "', " + Core::exact_text(solver.time()) + " s.");
    // What has been passed follows from the time, also if intervals changed.
    field_times.passes(solver.time());
    observable_times.passes(solver.time());
    checkpoint_trigger.start(solver.time());
    checkpoint_step = solver.step();
    manifest.resumed.push_back(
      "Continues from step " + std::to_string(solver.step()) + ", time " +
      Core::exact_text(solver.time()) + " s, of " +
      std::filesystem::path(info.checkpoint).filename().string());
  }

  template <int dim>
  void
  Run<dim>::reopen_output()
  {
    Output::on_first_rank(info.communicator, [&] {
      parameters.observables.reopen(folder.file("observables.csv"));
      console.open_log(folder.file("log.txt"), true);
      write_parameters();
      checkpoints.remove_newer_than(info.checkpoint);
      points_output.resume();
      grid_output.resume();
      manifest.write(folder.file("manifest.json"));
    });
  }

  template class Run<2>;
  template class Run<3>;
} // namespace mpm_granular::Solver
