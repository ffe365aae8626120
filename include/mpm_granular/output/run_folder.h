#ifndef mpm_granular_output_run_folder_h
#define mpm_granular_output_run_folder_h

#include <deal.II/base/mpi.h>

#include <functional>
#include <ostream>
#include <string>

namespace mpm_granular::Output
{
  /**
   * Writes a file so that at any moment either the old or the new one is there,
   * complete, even if the program is killed: the contents go to a temporary
   * name in the same folder, are brought to the disk, and renamed.
   *
   * @param path the file.
   * @param write writes the contents to the stream it is given. If it throws,
   *   the file stays as it was.
   * @throws ComputationError if the file cannot be written (say, a full disk).
   */
  void
  write_atomically(const std::string                         &path,
                   const std::function<void(std::ostream &)> &write);

  /**
   * Calls @p action on all ranks, each for itself. Collective.
   *
   * @throws InputError, ComputationError on all ranks, the same one, if it
   *   throws one or an error of the file system on any.
   */
  void
  on_all_ranks(const MPI_Comm               communicator,
               const std::function<void()> &action);

  /// Calls @p action on the first rank, while the others wait, see
  /// on_all_ranks().
  void
  on_first_rank(const MPI_Comm               communicator,
                const std::function<void()> &action);

  /**
   * The folder all files of a run go to. It belongs to one run: files of an
   * earlier one are never mixed with new ones nor overwritten unasked.
   */
  class RunFolder
  {
  public:
    /**
     * Nothing is made or removed yet.
     *
     * @param path the folder; it need not exist.
     * @param overwrite whether the files of an earlier run may be replaced.
     * @throws InputError if @p path cannot be the folder of this run: it is not
     *   a folder, or it is not empty and @p overwrite is false.
     */
    RunFolder(const std::string &path, const bool overwrite);

    /**
     * Makes the folder, with all folders above it. If it is there, removes what
     * a run writes, and nothing else.
     *
     * @throws InputError if that is not possible.
     */
    void
    prepare() const;

    /// The path of the file @p name of this folder.
    std::string
    file(const std::string &name) const;

    /// The folder as the user named it.
    const std::string &
    path() const
    {
      return folder;
    }

  private:
    std::string folder;
  };
} // namespace mpm_granular::Output

#endif
