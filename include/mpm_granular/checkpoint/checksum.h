#ifndef mpm_granular_checkpoint_checksum_h
#define mpm_granular_checkpoint_checksum_h

#include <deal.II/base/mpi.h>

#include <mpm_granular/core/hdf5_file.h>

#include <cstdint>

namespace mpm_granular::Checkpoint
{
  /**
   * The checksum of an array: the sum of a hash of every number with its place
   * in the whole array, so that it is the same however the rows are spread over
   * processes.
   *
   * @param extent which rows @p data has.
   */
  std::uint64_t
  checksum(const Core::NumberType type,
           const Core::Extent    &extent,
           const void            *data,
           const MPI_Comm         comm);
} // namespace mpm_granular::Checkpoint

#endif
