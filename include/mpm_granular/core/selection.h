#ifndef mpm_granular_core_selection_h
#define mpm_granular_core_selection_h

#ifdef __AVX512F__
#  include <immintrin.h>
#endif

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace mpm_granular
{
  /**
   * Which entries of an array eight others are copies of, for arrays of values
   * of runs that are to become values of points. To be used for many arrays.
   *
   * As runs have a point at least, the entries lie next to each other, and with
   * AVX-512 one permutation copies eight numbers; elsewhere they are copied one
   * by one.
   */
  class Selection
  {
  public:
    /// How many entries are selected at once.
    static constexpr unsigned int n = 8;

    /// As many numbers of entries.
    typedef std::uint32_t Entries
      __attribute__((vector_size(n * sizeof(std::uint32_t))));

    /// @param entries n numbers, each that of the one before or the next
    ///   greater.
    explicit Selection(const std::uint32_t *entries);

    /// Copies the entries of @p from to the first n of @p to.
    /// @param from readable up to n entries from the first selected one on.
    void
    copy(const double *from, double *to) const;

  private:
#ifdef __AVX512F__
    std::size_t first;
    __m512i     offsets; ///< from the first entry
#else
    const std::uint32_t *entries;
#endif
  };

#ifdef __AVX512F__
  // With a mask of all lanes, as of functions without one g++ warns.
  inline Selection::Selection(const std::uint32_t *entries)
    : first(entries[0])
  {
    const __m256i all =
      _mm256_loadu_si256(reinterpret_cast<const __m256i *>(entries));
    offsets = _mm512_maskz_cvtepu32_epi64(
      0xff, _mm256_sub_epi32(all, _mm256_set1_epi32(first)));
  }

  inline void
  Selection::copy(const double *from, double *to) const
  {
    const __m512d near = _mm512_loadu_pd(from + first);
    _mm512_storeu_pd(to, _mm512_maskz_permutexvar_pd(0xff, offsets, near));
  }
#else
  inline Selection::Selection(const std::uint32_t *entries)
    : entries(entries)
  {}

  inline void
  Selection::copy(const double *from, double *to) const
  {
    for (unsigned int i = 0; i < n; ++i)
      to[i] = from[entries[i]];
  }
#endif

  inline void
  store(const Selection::Entries &entries, std::uint32_t *to)
  {
    std::memcpy(to, &entries, sizeof(entries));
  }
} // namespace mpm_granular

#endif
