#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/core/synchronize.h>
#include <mpm_granular/output/run_folder.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <system_error>

namespace mpm_granular::Output
{
  namespace MPI = dealii::Utilities::MPI;
  namespace fs  = std::filesystem;

  namespace
  {
    /// What a run writes, relative to its folder, '/' between names.
    const std::regex &
    written_by_a_run()
    {
      static const std::regex pattern(
        "(parameters\\.prm|manifest\\.json|observables\\.csv|profile\\.csv|"
        "drive\\.csv|yield\\.csv|"
        "log\\.txt|(points|grid)\\.(pvd|xdmf)|"
        "(points/points|grid/grid)-[0-9]+(-[0-9]+)?\\.(vtu|pvtu|h5)|"
        "checkpoint/step-[0-9]+\\.h5)(\\.tmp)?");
      return pattern;
    }
  } // namespace



  void
  write_atomically(const std::string                         &path,
                   const std::function<void(std::ostream &)> &write)
  {
    const std::string temporary = path + ".tmp";
    try
      {
        std::ofstream stream(temporary, std::ios::binary);
        if (stream)
          write(stream);
        stream.close();
        if (!stream)
          throw ComputationError("Cannot write '" + path +
                                 "'. Is there space on the disk, and may the "
                                 "folder be written to?");
        Core::replace_file(temporary, path);
      }
    catch (...)
      {
        std::error_code ignored;
        fs::remove(temporary, ignored);
        throw;
      }
  }



  void
  on_all_ranks(const MPI_Comm communicator, const std::function<void()> &action)
  {
    // Empty if all is well; else I or C, for the kind, and the message.
    std::string error;
    try
      {
        action();
      }
    catch (const InputError &exception)
      {
        error = std::string("I") + exception.what();
      }
    catch (const ComputationError &exception)
      {
        error = std::string("C") + exception.what();
      }
    catch (const std::system_error &exception)
      {
        error = std::string("C") + exception.what();
      }
    if (MPI::max(error.empty() ? 0 : 1, communicator) == 0)
      return;
    for (const auto &first : MPI::all_gather(communicator, error))
      if (!first.empty())
        {
          if (first[0] == 'I')
            throw InputError(first.substr(1));
          throw ComputationError(first.substr(1));
        }
  }



  void
  on_first_rank(const MPI_Comm               communicator,
                const std::function<void()> &action)
  {
    on_all_ranks(communicator, [&] {
      if (MPI::this_mpi_process(communicator) == 0)
        action();
    });
  }



  RunFolder::RunFolder(const std::string &path, const bool overwrite)
    : folder(path)
  {
    require(!folder.empty(), "The output directory has no name.");
    std::error_code error;
    if (!fs::exists(folder, error))
      return;
    require(fs::is_directory(folder, error),
            "The output directory '" + folder + "' is a file.");
    const bool is_empty = fs::is_empty(folder, error);
    require(!error,
            "The output directory '" + folder +
              "' cannot be read: " + error.message() + ".");
    require(is_empty || overwrite,
            "The output directory '" + folder +
              "' is not empty. Choose another one, or allow with --overwrite "
              "that the files of the earlier run are replaced.");
  }



  void
  RunFolder::prepare() const
  {
    try
      {
        fs::create_directories(folder);
        for (const std::string part : {"", "points", "grid", "checkpoint"})
          {
            const fs::path place = fs::path(folder) / part;
            if (!fs::is_directory(place))
              continue;
            // List first: what a folder iterator does while files vanish is not
            // specified.
            std::vector<fs::path> old_files;
            for (const auto &entry : fs::directory_iterator(place))
              {
                const std::string name = entry.path().filename().string();
                if (!entry.is_directory() &&
                    std::regex_match(part.empty() ? name : part + "/" + name,
                                     written_by_a_run()))
                  old_files.push_back(entry.path());
              }
            for (const auto &file : old_files)
              fs::remove(file);
          }
      }
    catch (const fs::filesystem_error &error)
      {
        throw InputError("The output directory '" + folder +
                         "' cannot be prepared: " + error.what() + ".");
      }
  }



  std::string
  RunFolder::file(const std::string &name) const
  {
    return (fs::path(folder) / name).string();
  }
} // namespace mpm_granular::Output
