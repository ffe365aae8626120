#ifndef mpm_granular_core_exit_code_h
#define mpm_granular_core_exit_code_h

#include <functional>

namespace mpm_granular::Core
{
  /// What the program returns to the shell; these numbers are documented.
  enum class ExitCode
  {
    done               = 0,
    input_refused      = 1,
    computation_failed = 2,
    interrupted        = 3
  };

  /**
   * Calls @p program. If an exception leaves it, writes one message to standard
   * error and returns the exit code that belongs to it. If that happens on some
   * of the MPI processes only, all of them are ended with that exit code.
   */
  ExitCode
  run_and_report(const std::function<ExitCode()> &program);
} // namespace mpm_granular::Core

#endif
