#ifndef mpm_granular_output_xdmf_file_h
#define mpm_granular_output_xdmf_file_h

#include <deal.II/base/mpi.h>

#include <mpm_granular/output/contents.h>

#include <ostream>
#include <string>
#include <vector>

namespace mpm_granular::Output
{
  /**
   * Writes an HDF5 file, all ranks together, in pieces of so many rows that the
   * memory does not grow with the run, atomically (see
   * Core::write_hdf5_atomically()): arrays
   * `position`, `cells` (the nodes of each item), `fields/NAME`, `time`, with
   * the ranks' rows in the order of the ranks. Positions and vectors have three
   * components. Numbers are those of a VTU file, of single precision; natural
   * ones are exact.
   *
   * @param time [s].
   * @param compression_level from 0, not at all, to 9.
   * @throws ComputationError on all ranks if it cannot be written.
   */
  template <int item_dim, int dim>
  void
  write_hdf5(const std::string             &path,
             const double                   time,
             const unsigned int             compression_level,
             const Contents<item_dim, dim> &contents,
             const MPI_Comm                 communicator);

  /**
   * The description of such a file for XDMF, in one line.
   *
   * @param file the name of the file, relative to the XDMF file's folder.
   */
  template <int item_dim, int dim>
  std::string
  xdmf_grid(const std::string             &file,
            const double                   time,
            const Contents<item_dim, dim> &contents,
            const MPI_Comm                 communicator);

  /// Writes an XDMF file with such descriptions, one for each instant.
  void
  write_xdmf(std::ostream                   &out,
             const std::string              &name,
             const std::vector<std::string> &grids);
} // namespace mpm_granular::Output

#endif
