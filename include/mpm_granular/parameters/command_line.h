#ifndef mpm_granular_parameters_command_line_h
#define mpm_granular_parameters_command_line_h

#include <mpm_granular/parameters/listing.h>

#include <string>
#include <vector>

namespace mpm_granular::Parameters
{
  /// What the command line asks for.
  struct CommandLine
  {
    enum class Task
    {
      run,
      check, ///< stop after the pre-flight report
      print_parameters,
      show_help,
      show_version
    };

    Task        task = Task::run;
    std::string file; ///< the parameter file; empty: none

    /// The folder of the run to continue; empty: a new run.
    std::string resume;

    /// "Section/Entry=value" of --set and of options that stand for an entry.
    std::vector<std::string> overrides;

    bool  drive       = false; ///< the file is of a test of a material point
    bool  overwrite   = false;
    Style print_style = Style::parameter_file;

    std::string text; ///< the command line as it could be typed again
  };

  /**
   * @param argc,argv as of main().
   * @throws InputError for what cannot be understood or does not go together,
   *   and if there is no parameter file where one is needed.
   */
  CommandLine
  parse_command_line(const int argc, const char *const *argv);

  /// The text of --help.
  std::string
  usage();

  /// The text of --version: this program, compiler, deal.II and its packages.
  std::string
  version_text();
} // namespace mpm_granular::Parameters

#endif
