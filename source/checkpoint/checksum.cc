#include <mpm_granular/checkpoint/checksum.h>
#include <mpm_granular/core/hash.h>

#include <cstring>

namespace mpm_granular::Checkpoint
{
  namespace
  {
    /// The sum over the numbers of this process.
    template <class Bits>
    std::uint64_t
    local_sum(const Core::Extent &extent, const void *data)
    {
      const std::uint64_t first  = extent.first_row * extent.width;
      const std::uint64_t n      = extent.n_local_rows * extent.width;
      const char         *number = static_cast<const char *>(data);
      std::uint64_t       sum    = 0;
      for (std::uint64_t i = 0; i < n; ++i, number += sizeof(Bits))
        {
          Bits bits;
          std::memcpy(&bits, number, sizeof(Bits));
          sum += Core::combined(first + i, bits);
        }
      return sum;
    }
  } // namespace



  std::uint64_t
  checksum(const Core::NumberType type,
           const Core::Extent    &extent,
           const void            *data,
           const MPI_Comm         comm)
  {
    const auto          size = Core::size_of(type);
    const std::uint64_t sum =
      size == 8 ? local_sum<std::uint64_t>(extent, data) :
      size == 4 ? local_sum<std::uint32_t>(extent, data) :
                  local_sum<std::uint8_t>(extent, data);
    return dealii::Utilities::MPI::sum(sum, comm);
  }
} // namespace mpm_granular::Checkpoint
