#ifndef mpm_granular_output_vtu_file_h
#define mpm_granular_output_vtu_file_h

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

#include <mpm_granular/output/contents.h>

#include <ostream>
#include <string>
#include <vector>

namespace mpm_granular::Output
{
  /**
   * Writes a VTU file with the functions of deal.II, in pieces of at most
   * max_piece_size items, atomically (see write_atomically()).
   *
   * @param path only the first rank's is used.
   * @param flags compression, time and the like.
   * @param contents what this rank adds.
   * @param communicator of the ranks whose contents make up the file;
   *   collective. The first rank asks them one by one for their pieces.
   * @throws ComputationError on the first rank if it cannot be written.
   */
  template <int item_dim, int dim>
  void
  write_vtu(const std::string                   &path,
            const dealii::DataOutBase::VtkFlags &flags,
            const Contents<item_dim, dim>       &contents,
            const MPI_Comm                       communicator);

  /**
   * Writes the PVTU file of VTU files that show one thing together.
   *
   * @param files their names, relative to its folder.
   * @param fields those of the files.
   */
  void
  write_pvtu(std::ostream                        &out,
             const dealii::DataOutBase::VtkFlags &flags,
             const std::vector<std::string>      &files,
             const std::vector<Field>            &fields);
} // namespace mpm_granular::Output

#endif
