#ifndef mpm_granular_checkpoint_checkpoint_folder_h
#define mpm_granular_checkpoint_checkpoint_folder_h

#include <mpm_granular/checkpoint/checkpoint_file.h>

#include <functional>
#include <string>
#include <vector>

namespace mpm_granular::Checkpoint
{
  /// The folder `checkpoint` of a run, with the files `step-000012345.h5`.
  class CheckpointFolder
  {
  public:
    /**
     * Nothing is made yet.
     *
     * @param run_folder the folder of the run.
     * @param n_kept how many files stay, at least 1.
     */
    CheckpointFolder(const std::string &run_folder,
                     const unsigned int n_kept,
                     const MPI_Comm     comm);

    /**
     * Writes the checkpoint of a step, see Checkpoint::write(), then removes
     * the oldest files that are too many.
     *
     * @throws ComputationError if it cannot be written.
     */
    void
    write(const unsigned int                          step,
          const std::function<void(Core::Archive &)> &serialize) const;

    /// The files, the newest first.
    std::vector<std::string>
    files() const;

    /// Removes what is newer than @p file, and incomplete files: what a run
    /// that continues from @p file writes anew.
    void
    remove_newer_than(const std::string &file) const;

  private:
    const std::string  folder;
    const unsigned int n_kept;
    const MPI_Comm     comm;
  };

  /// A checkpoint to continue from.
  struct StartingPoint
  {
    std::string file;           ///< the checkpoint
    std::string parameter_text; ///< a complete parameter file
    std::string input_file;     ///< that file names are relative to

    /// Why newer checkpoints are not used.
    std::vector<std::string> remarks;
  };

  /// What a run says of itself in its checkpoints; the counterpart of
  /// newest_checkpoint().
  void
  serialize_input(Core::Archive &archive,
                  std::string   &parameter_text,
                  std::string   &input_file);

  /**
   * The newest checkpoint of a run that is complete and undamaged.
   *
   * @throws InputError if there is none.
   */
  StartingPoint
  newest_checkpoint(const std::string &run_folder, const MPI_Comm comm);
} // namespace mpm_granular::Checkpoint

#endif
