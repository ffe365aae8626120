#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <mpm_granular/checkpoint/checkpoint_folder.h>
#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/core/exit_code.h>
#include <mpm_granular/core/signals.h>
#include <mpm_granular/drive/drive_parameters.h>
#include <mpm_granular/drive/drive_run.h>
#include <mpm_granular/parameters/changes.h>
#include <mpm_granular/parameters/command_line.h>
#include <mpm_granular/parameters/dimension.h>
#include <mpm_granular/parameters/listing.h>
#include <mpm_granular/parameters/parameter_file.h>
#include <mpm_granular/parameters/run_info.h>
#include <mpm_granular/solver/run.h>
#include <mpm_granular/solver/run_parameters.h>

#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace
{
  using namespace mpm_granular;
  using Core::ExitCode;
  using Parameters::CommandLine;



  /// --print-parameters, of @p parameters with their defaults.
  void
  print_parameters(Parameters::ParameterGroup &parameters,
                   const CommandLine          &command_line)
  {
    using namespace Parameters;
    const bool everything_possible =
      command_line.file.empty() && command_line.print_style == Style::markdown;
    write(everything_possible ?
            documented_entries(parameters) :
            read(parameters, command_line.file, command_line.overrides),
          std::cout,
          command_line.print_style);
  }



  /// Where the parameters of a run come from.
  struct Origin
  {
    Parameters::InputSource  source;
    std::vector<std::string> overrides;
    std::string              input_file; ///< that file names are relative to
    std::string              checkpoint; ///< empty: a new run
    std::vector<std::string> remarks;
  };



  /// The parameter file, or the newest checkpoint of the run to continue.
  Origin
  origin_of(const CommandLine &command_line)
  {
    if (command_line.resume.empty())
      return {
        command_line.file, command_line.overrides, command_line.file, "", {}};

    const auto start =
      Checkpoint::newest_checkpoint(command_line.resume, MPI_COMM_WORLD);
    Origin origin{{start.file, start.parameter_text},
                  command_line.overrides,
                  start.input_file,
                  start.file,
                  start.remarks};
    origin.overrides.push_back("Output/Directory=" + command_line.resume);
    return origin;
  }



  /// What the run or test writes as its parameters, and how it was called.
  Parameters::RunInfo
  run_info(const CommandLine                    &command_line,
           const Origin                         &origin,
           const std::vector<Parameters::Entry> &entries)
  {
    std::ostringstream text;
    text << "# Every entry as used by\n#   " << command_line.text
         << "\n# File names are relative to the folder of "
         << std::filesystem::absolute(origin.input_file).string() << "\n\n";
    Parameters::write(entries, text, Parameters::Style::parameter_file);

    Parameters::RunInfo info;
    info.command_line   = command_line.text;
    info.input_file     = origin.input_file;
    info.parameter_text = text.str();
    info.checkpoint     = origin.checkpoint;
    info.remarks        = origin.remarks;
    info.overwrite      = command_line.overwrite;
    info.check_only     = command_line.task == CommandLine::Task::check;
    return info;
  }



  /// Tests a material point.
  void
  drive(const CommandLine &command_line, const Origin &origin)
  {
    Drive::DriveParameters parameters;
    const auto             entries =
      Parameters::read(parameters, origin.source, origin.overrides);
    Parameters::check(parameters, origin.source.name);
    const auto info = run_info(command_line, origin, entries);
    Drive::DriveRun(parameters, info).execute();
  }



  /// Reads the parameters, sets the run up, and runs it.
  template <int dim>
  ExitCode
  run_case(const CommandLine &command_line, const Origin &origin)
  {
    Solver::RunParameters<dim> parameters;
    const auto                 entries =
      Parameters::read(parameters, origin.source, origin.overrides);
    if (!origin.checkpoint.empty())
      {
        Solver::RunParameters<dim> before;
        Parameters::refuse_changes(Parameters::read(before, origin.source),
                                   entries,
                                   Solver::changeable_on_resume(),
                                   "when a run is continued: it would be "
                                   "another run. Start a new one.");
      }
    Parameters::check(parameters, origin.source.name);

    const auto       info = run_info(command_line, origin, entries);
    Solver::Run<dim> run(parameters, info);
    if (!info.check_only)
      Core::catch_signals();
    return run.execute() == Solver::Outcome::finished ? ExitCode::done :
                                                        ExitCode::interrupted;
  }



  ExitCode
  dispatch(const CommandLine &command_line)
  {
    using Task = CommandLine::Task;
    if (command_line.task == Task::show_help)
      std::cout << Parameters::usage();
    else if (command_line.task == Task::show_version)
      std::cout << Parameters::version_text();
    else
      {
        const Origin origin = origin_of(command_line);
        if (command_line.drive)
          {
            Drive::DriveParameters parameters;
            if (command_line.task == Task::print_parameters)
              print_parameters(parameters, command_line);
            else
              drive(command_line, origin);
            return ExitCode::done;
          }
        // Of a run that is continued, the dimension cannot be changed.
        const bool is_2d =
          Parameters::read_dimension(origin.source,
                                     origin.checkpoint.empty() ?
                                       origin.overrides :
                                       std::vector<std::string>()) == 2;
        if (command_line.task == Task::print_parameters)
          {
            Solver::RunParameters<2> in_2d;
            Solver::RunParameters<3> in_3d;
            is_2d ? print_parameters(in_2d, command_line) :
                    print_parameters(in_3d, command_line);
          }
        else
          return is_2d ? run_case<2>(command_line, origin) :
                         run_case<3>(command_line, origin);
      }
    return ExitCode::done;
  }
} // namespace



int
main(int argc, char **argv)
{
  // PETSc, which may be a part of deal.II, would take --help and --version for
  // itself: it gets to see the name of the program only.
  int                                            n_seen   = 1;
  char                                          *seen[]   = {argv[0], nullptr};
  char                                         **pointers = seen;
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(n_seen, pointers, 1);

  // Assertions of deal.II become exceptions, whose texts have no stack.
  dealii::deal_II_exceptions::disable_abort_on_exception();
  dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();

  return static_cast<int>(Core::run_and_report([&] {
    const CommandLine command_line = Parameters::parse_command_line(argc, argv);
    return dispatch(command_line);
  }));
}
