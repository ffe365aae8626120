#include <mpm_granular/checkpoint/checkpoint_folder.h>
#include <mpm_granular/core/exceptions.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <system_error>

namespace mpm_granular::Checkpoint
{
  namespace MPI = dealii::Utilities::MPI;
  namespace fs  = std::filesystem;

  namespace
  {
    /// Names in a folder that match, the last one in alphabetical order first.
    std::vector<std::string>
    list(const std::string &folder, const std::regex &pattern)
    {
      std::vector<std::string> names;
      std::error_code          error;
      for (const auto &entry : fs::directory_iterator(folder, error))
        if (std::regex_match(entry.path().filename().string(), pattern))
          names.push_back(entry.path().string());
      std::sort(names.rbegin(), names.rend());
      return names;
    }
  } // namespace



  CheckpointFolder::CheckpointFolder(const std::string &run_folder,
                                     const unsigned int n_kept,
                                     const MPI_Comm     comm)
    : folder((fs::path(run_folder) / "checkpoint").string())
    , n_kept(n_kept)
    , comm(comm)
  {}



  void
  CheckpointFolder::write(
    const unsigned int                          step,
    const std::function<void(Core::Archive &)> &serialize) const
  {
    std::error_code ignored; // writing will fail with a message
    if (MPI::this_mpi_process(comm) == 0)
      fs::create_directories(folder, ignored);
    // As many digits as a step can have: names sort as numbers.
    const std::string name =
      "step-" + dealii::Utilities::int_to_string(step, 10) + ".h5";
    Checkpoint::write((fs::path(folder) / name).string(), comm, serialize);

    const auto all = files();
    if (MPI::this_mpi_process(comm) == 0)
      for (std::size_t i = n_kept; i < all.size(); ++i)
        fs::remove(all[i], ignored);
  }



  std::vector<std::string>
  CheckpointFolder::files() const
  {
    // The first process looks, so that all see the same.
    std::vector<std::string> names;
    if (MPI::this_mpi_process(comm) == 0)
      names = list(folder, std::regex("step-[0-9]+\\.h5"));
    return MPI::broadcast(comm, names);
  }



  void
  CheckpointFolder::remove_newer_than(const std::string &file) const
  {
    if (MPI::this_mpi_process(comm) != 0)
      return;
    std::error_code ignored;
    for (const auto &other : list(folder, std::regex("step-[0-9]+\\.h5")))
      if (fs::path(other).filename() > fs::path(file).filename())
        fs::remove(other, ignored);
    for (const auto &other : list(folder, std::regex("step-[0-9]+\\.h5\\.tmp")))
      fs::remove(other, ignored);
  }



  void
  serialize_input(Core::Archive &archive,
                  std::string   &parameter_text,
                  std::string   &input_file)
  {
    archive.replicated("input/parameters", parameter_text);
    archive.replicated("input/file", input_file);
  }



  StartingPoint
  newest_checkpoint(const std::string &run_folder, const MPI_Comm comm)
  {
    std::error_code ignored;
    require(fs::is_directory(run_folder, ignored),
            "--resume: there is no folder '" + run_folder + "'.");
    const auto files = CheckpointFolder(run_folder, 1, comm).files();
    require(!files.empty(),
            "--resume: there is no checkpoint in '" + run_folder +
              "/checkpoint'.");

    StartingPoint start;
    for (const auto &file : files)
      try
        {
          Reader reader(file, comm);
          serialize_input(reader, start.parameter_text, start.input_file);
          start.file = file;
          return start;
        }
      catch (const InputError &error)
        {
          start.remarks.push_back(error.what());
        }
    std::string reasons;
    for (const auto &remark : start.remarks)
      reasons += "\n" + remark;
    throw InputError("--resume: no checkpoint of '" + run_folder +
                     "' can be used." + reasons);
  }
} // namespace mpm_granular::Checkpoint
