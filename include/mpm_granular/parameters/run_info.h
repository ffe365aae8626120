#ifndef mpm_granular_parameters_run_info_h
#define mpm_granular_parameters_run_info_h

#include <deal.II/base/mpi.h>

#include <string>
#include <vector>

namespace mpm_granular::Parameters
{
  /// What a run knows of how it was called, beside its parameters.
  struct RunInfo
  {
    /// The command line as typed, for the manifest.
    std::string command_line;

    /// The parameter file as named; see resolve_input_file() for the files that
    /// its entries name.
    std::string input_file;

    /// Every entry with the value used, as a complete parameter file.
    std::string parameter_text;

    /// The checkpoint to continue from; empty: a new run.
    std::string checkpoint;

    /// What the user should know before the run starts.
    std::vector<std::string> remarks;

    /// Whether the files of an earlier run may be replaced.
    bool overwrite = false;

    /// Whether to stop after the pre-flight report; nothing is written.
    bool check_only = false;

    /// The MPI ranks that share the run.
    MPI_Comm communicator = MPI_COMM_WORLD;
  };
} // namespace mpm_granular::Parameters

#endif
