#ifndef mpm_granular_checkpoint_checkpoint_file_h
#define mpm_granular_checkpoint_checkpoint_file_h

#include <mpm_granular/core/archive.h>
#include <mpm_granular/core/hdf5_file.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

/*
 * The file of a checkpoint; doc/checkpoint.md describes the format.
 */
namespace mpm_granular::Checkpoint
{
  /// Files of a later version are refused.
  constexpr std::uint64_t format_version = 1;

  /**
   * Writes a checkpoint so that at any moment either a complete file has the
   * name @p path or none: HDF5 writes to a temporary name, closes it, and the
   * file is brought to the disk before it gets its name.
   *
   * All processes of @p comm write one file together.
   *
   * @param serialize gives the archive what is to be kept.
   * @throws ComputationError on all processes if that is not possible.
   */
  void
  write(const std::string                          &path,
        const MPI_Comm                              comm,
        const std::function<void(Core::Archive &)> &serialize);

  /// A checkpoint file that is read.
  class Reader : public Core::Archive
  {
  public:
    /**
     * Opens the file and compares all its data with their checksums.
     *
     * @throws InputError on all processes if the file is damaged, or of a
     *   later format.
     */
    Reader(const std::string &path, const MPI_Comm comm);

    bool
    is_reading() const override
    {
      return true;
    }

    bool
    has_same_ranks() const override;

    /// Name of the file.
    const std::string &
    path() const
    {
      return file_name;
    }

  private:
    void
    replicate(const std::string &name, const Numbers &numbers) override;

    void
    distribute(const std::string &name,
               const Numbers     &numbers,
               const unsigned int width) override;

    /// Compares all arrays with their checksums.
    void
    verify();

    /// The rows of a group's arrays that this process reads.
    void
    choose_rows(const std::string &group, Core::Extent &extent);

    [[noreturn]] void
    refuse(const std::string &reason) const;

    const std::string                                 file_name;
    const MPI_Comm                                    comm;
    std::unique_ptr<Core::Hdf5File>                   file;
    std::uint64_t                                     n_ranks_then = 0;
    std::map<std::string, std::vector<std::uint64_t>> offsets; ///< by group
  };
} // namespace mpm_granular::Checkpoint

#endif
