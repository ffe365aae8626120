#ifndef mpm_granular_output_file_series_h
#define mpm_granular_output_file_series_h

#include <deal.II/base/mpi.h>

#include <mpm_granular/core/archive.h>
#include <mpm_granular/output/contents.h>
#include <mpm_granular/output/output_parameters.h>

#include <string>
#include <utility>
#include <vector>

namespace mpm_granular::Output
{
  /**
   * A series of files over time, in one of the formats of OutputParameters,
   * with a record that ParaView opens:
   *
   * | format | files                                            | record    |
   * |--------|--------------------------------------------------|-----------|
   * | VTU    | `NAME/NAME-00000.vtu`                            | NAME.pvd  |
   * | PVTU   | `NAME/NAME-00000.pvtu`, `NAME-00000-0000.vtu`, … | NAME.pvd  |
   * | HDF5   | `NAME/NAME-00000.h5`                             | NAME.xdmf |
   *
   * All files are written atomically, the record last: at any moment it names
   * complete files only.
   */
  class FileSeries
  {
  public:
    /**
     * @param parameters folder, which is looked at at the first write only,
     *   format and compression.
     * @param name name of the series.
     * @param communicator of the ranks that call add().
     */
    FileSeries(const OutputParameters &parameters,
               const std::string      &name,
               const MPI_Comm          communicator);

    /**
     * Writes the files of the next instant and the record. Collective.
     *
     * @param time [s].
     * @param step number of steps done.
     * @param contents what this rank adds.
     * @throws ComputationError on all ranks if a file cannot be written.
     */
    template <int item_dim, int dim>
    void
    add(const double                   time,
        const unsigned int             step,
        const Contents<item_dim, dim> &contents);

    /// The number of instants.
    unsigned int
    n_files() const
    {
      return times_and_names.size();
    }

    /// The instants so far, for checkpoints.
    /// @throws InputError if they are in another format.
    void
    serialize(Core::Archive &archive);

    /// Goes on in the folder of an interrupted run: removes the files after
    /// those that serialize() knows of, also from the record.
    void
    resume();

  private:
    /// A path in the folder.
    std::string
    path(const std::string &file) const;

    /// The name of what the record refers to, relative to the folder.
    std::string
    file_name(const unsigned int index) const;

    std::string
    record_name() const;

    void
    write_record() const;

    /// Writes the VTU file @p file, or, if that is the format, one for each
    /// group of ranks and the PVTU file @p file.
    template <int item_dim, int dim>
    void
    write_vtu_files(const std::string             &file,
                    const double                   time,
                    const unsigned int             step,
                    const Contents<item_dim, dim> &contents) const;

    OutputParameters                            parameters;
    std::string                                 name;
    MPI_Comm                                    communicator;
    std::vector<std::pair<double, std::string>> times_and_names;
    std::vector<std::string>                    xdmf_grids; ///< HDF5 only
  };
} // namespace mpm_granular::Output

#endif
