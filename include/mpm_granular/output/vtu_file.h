#ifndef mpm_granular_output_vtu_file_h
#define mpm_granular_output_vtu_file_h

#include <deal.II/base/mpi.h>

#include <mpm_granular/output/contents.h>

#include <ostream>
#include <string>
#include <vector>

namespace mpm_granular::Output
{
  /**
   * Writes a VTU file with a piece of each rank that has items, atomically (see
   * write_atomically()). The arrays stand behind the XML, as they are in memory
   * or compressed by zlib: first that of the positions, rank by rank, then
   * those of the cells and of the fields. Numbers are of single precision,
   * natural ones exact; positions and vectors have three components.
   *
   * @param path only the first rank's is used.
   * @param time [s].
   * @param step number of steps done.
   * @param compression_level from 0, not at all, to 9.
   * @param contents what this rank adds.
   * @param communicator of the ranks whose contents make up the file;
   *   collective. The first rank asks them one by one for each array, so that
   *   none holds more than one array of one rank.
   * @throws ComputationError on the first rank if it cannot be written.
   */
  template <int item_dim, int dim>
  void
  write_vtu(const std::string             &path,
            const double                   time,
            const unsigned int             step,
            const unsigned int             compression_level,
            const Contents<item_dim, dim> &contents,
            const MPI_Comm                 communicator);

  /**
   * Writes the PVTU file of VTU files that show one thing together.
   *
   * @param files their names, relative to its folder.
   * @param fields those of the files.
   */
  void
  write_pvtu(std::ostream                   &out,
             const std::vector<std::string> &files,
             const std::vector<Field>       &fields);
} // namespace mpm_granular::Output

#endif
