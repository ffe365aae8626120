#include <deal.II/base/mpi.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/core/exit_code.h>
#include <mpm_granular/core/hdf5_file.h>

#include <chrono>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <sstream>
#include <string>
#include <thread>

namespace mpm_granular::Core
{
  namespace
  {
    /// Whether all ranks come here within some seconds: an error that all have
    /// met together, rather than one that leaves the others waiting for ever.
    bool
    all_ranks_fail()
    {
      using Clock          = std::chrono::steady_clock;
      const auto  patience = std::chrono::seconds(5);
      const auto  begin    = Clock::now();
      MPI_Request request;
      int         have_all = 0;
      if (MPI_Ibarrier(MPI_COMM_WORLD, &request) != MPI_SUCCESS)
        return false;
      while (have_all == 0 && Clock::now() - begin < patience)
        {
          MPI_Test(&request, &have_all, MPI_STATUS_IGNORE);
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
      return have_all != 0;
    }



    /// Says @p message once for all ranks. If this rank fails alone, ends them
    /// all with the exit code.
    ExitCode
    report(const std::string &message, const ExitCode code)
    {
      namespace MPI  = dealii::Utilities::MPI;
      const auto say = [&](const std::string &who) {
        std::cout.flush();
        std::cerr << "mpm_granular: error" << who << ": " << message
                  << std::endl;
      };
      int is_parallel = 0;
      MPI_Initialized(&is_parallel);
      if (is_parallel == 0 || MPI::n_mpi_processes(MPI_COMM_WORLD) == 1)
        say("");
      else
        {
          const unsigned int rank = MPI::this_mpi_process(MPI_COMM_WORLD);
          if (!all_ranks_fail())
            {
              say(" on process " + std::to_string(rank));
              MPI_Abort(MPI_COMM_WORLD, static_cast<int>(code));
            }
          if (rank == 0)
            say("");
        }
      if (Hdf5File::is_broken())
        std::_Exit(static_cast<int>(code)); // without MPI_Finalize()
      return code;
    }



    /// The text of an exception without deal.II's rulers and empty lines.
    std::string
    compact_text(const std::exception &error)
    {
      std::istringstream lines(error.what());
      std::string        text, line;
      while (std::getline(lines, line))
        if (line.find_first_not_of("- \t\r") != std::string::npos)
          text += (text.empty() ? "" : "\n") + line;
      return text;
    }
  } // namespace



  ExitCode
  run_and_report(const std::function<ExitCode()> &program)
  {
    try
      {
        return program();
      }
    catch (const InputError &error)
      {
        return report(error.what(), ExitCode::input_refused);
      }
    catch (const ComputationError &error)
      {
        return report(error.what(), ExitCode::computation_failed);
      }
    catch (const std::bad_alloc &)
      {
        return report("There is not enough memory. Fewer cells and points need "
                      "less; --check estimates how much a run needs.",
                      ExitCode::computation_failed);
      }
    catch (const std::exception &error)
      {
        return report("This is a fault of the program, please report it.\n" +
                        compact_text(error),
                      ExitCode::computation_failed);
      }
    catch (...)
      {
        return report("This is a fault of the program, please report it.",
                      ExitCode::computation_failed);
      }
  }
} // namespace mpm_granular::Core
