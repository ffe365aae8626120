#ifndef mpm_granular_core_hdf5_file_h
#define mpm_granular_core_hdf5_file_h

#include <deal.II/base/mpi.h>

#include <hdf5.h>

#include <mpm_granular/core/number_type.h>

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

namespace mpm_granular::Core
{
  /// HDF5 could not do what it was asked to.
  class Hdf5Error : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };

  /// An array as it lies in a file: all rows, and those of this process.
  struct Extent
  {
    std::uint64_t n_rows       = 0; ///< of all processes
    std::uint64_t first_row    = 0; ///< of this process
    std::uint64_t n_local_rows = 0;
    std::uint64_t width        = 1; ///< numbers a row
  };

  /**
   * An HDF5 file that several processes write or read together. (deal.II's
   * classes for HDF5 look at errors in Debug only, and lack the types needed
   * here.)
   *
   * All functions are called by all processes. They throw Hdf5Error on all of
   * them, even if only one has failed, so that none waits for another.
   */
  class Hdf5File
  {
  public:
    enum class Mode
    {
      create,
      read
    };

    Hdf5File(const std::string &path, const Mode mode, const MPI_Comm comm);

    /// Closes the file without looking at errors, unless that has been done.
    ~Hdf5File();

    Hdf5File(const Hdf5File &) = delete;
    Hdf5File &
    operator=(const Hdf5File &) = delete;

    /// Closes the file, so that all of it is handed to the system.
    void
    close();

    /// Whether a file of this process could not be closed, say on a full disk.
    /// HDF5, which is ended by MPI_Finalize(), then crashes there.
    static bool
    is_broken();

    /// The type and the extent of the array @p name; nothing is of this
    /// process yet. A text has one row.
    Extent
    extent(const std::string &name, NumberType &type) const;

    /// Makes the array @p name, "name" or "group/name", with its group if needed.
    /// Texts, arrays of characters, have the type string.
    void
    write(const std::string &name,
          const NumberType   type,
          const Extent      &extent,
          const void        *data);

    /// How an array is written that is made piece by piece.
    struct Pieces
    {
      std::uint64_t n_rows;            ///< in a piece of a process, at most
      unsigned int  compression_level; ///< 0, not at all, to 9
    };

    /**
     * The same without having all rows at a time.
     *
     * @param piece gives @p n_rows rows of this process from its row @p first
     *   on; they are used before the next call.
     */
    void
    write_in_pieces(
      const std::string                                             &name,
      const NumberType                                               type,
      const Extent                                                  &extent,
      const Pieces                                                  &pieces,
      const std::function<const void *(const std::uint64_t first,
                                       const std::uint64_t n_rows)> &piece);

    /// Reads this process's rows of the array @p name.
    void
    read(const std::string &name,
         const NumberType   type,
         const Extent      &extent,
         void              *data) const;

    /// An attribute of the array @p object, or of the file with "/".
    void
    write_attribute(const std::string  &object,
                    const std::string  &name,
                    const std::uint64_t value);

    std::uint64_t
    read_attribute(const std::string &object, const std::string &name) const;

  private:
    /// Closes the file. @return whether that worked on this process.
    bool
    try_to_close();

    /// Throws unless @p is_good on all processes.
    void
    require_on_all(const bool is_good, const std::string &what) const;

    /// Writes or reads the rows of an open data set. @return whether that
    /// worked on this process.
    static bool
    transfer(const Mode       mode,
             const hid_t      dataset,
             const NumberType type,
             const Extent    &extent,
             void            *data);

    const MPI_Comm comm;
    hid_t          file = -1;
  };

  /**
   * Writes an HDF5 file so that at any moment either a complete file has the
   * name @p path or none: HDF5 writes to a temporary name, closes it, and the
   * file is brought to the disk before it gets its name.
   *
   * All processes of @p comm write one file together.
   *
   * @throws ComputationError on all processes if that is not possible.
   */
  void
  write_hdf5_atomically(const std::string                     &path,
                        const MPI_Comm                         comm,
                        const std::function<void(Hdf5File &)> &write);
} // namespace mpm_granular::Core

#endif
