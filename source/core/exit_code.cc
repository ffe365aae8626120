#include <deal.II/base/mpi.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/core/exit_code.h>

#include <exception>
#include <iostream>
#include <new>
#include <sstream>
#include <string>

namespace mpm_granular::Core
{
  namespace
  {
    void
    report(const std::string &message)
    {
      namespace MPI = dealii::Utilities::MPI;
      if (!MPI::job_supports_mpi() ||
          MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
        {
          std::cout.flush();
          std::cerr << "mpm_granular: error: " << message << std::endl;
        }
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
        report(error.what());
        return ExitCode::input_refused;
      }
    catch (const ComputationError &error)
      {
        report(error.what());
      }
    catch (const std::bad_alloc &)
      {
        report("There is not enough memory. Fewer cells and points need less; "
               "--check estimates how much a run needs.");
      }
    catch (const std::exception &error)
      {
        report("This is a fault of the program, please report it.\n" +
               compact_text(error));
      }
    catch (...)
      {
        report("This is a fault of the program, please report it.");
      }
    return ExitCode::computation_failed;
  }
} // namespace mpm_granular::Core
