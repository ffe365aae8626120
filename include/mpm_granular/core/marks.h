#ifndef mpm_granular_core_marks_h
#define mpm_granular_core_marks_h

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace mpm_granular
{
  /// for_each_marked() looks at whole groups of so many.
  constexpr unsigned int n_marks = 64;

  /**
   * Calls @p action(i) for those of the first n for which @p is_marked(i), in
   * order. Without a branch for each, which cannot be predicted where the
   * marked ones are scattered, and vectorized.
   *
   * @param is_marked is called for the others of the last group, too, up to the
   *   next multiple of n_marks.
   */
  template <class IsMarked, class Action>
  inline void
  for_each_marked(const unsigned int n, IsMarked &&is_marked, Action &&action)
  {
    // The product below moves the last bits of eight bytes next to each other.
    static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__);
    constexpr unsigned int n_bytes = sizeof(std::uint64_t);
    for (std::size_t first = 0; first < n; first += n_marks)
      {
        std::array<std::uint8_t, n_marks> bytes;
        for (std::size_t i = 0; i < n_marks; ++i)
          bytes[i] = is_marked(first + i);
        std::uint64_t bits = 0;
        for (unsigned int i = 0; i < n_marks; i += n_bytes)
          {
            std::uint64_t of_bytes;
            std::memcpy(&of_bytes, &bytes[i], n_bytes);
            bits |= (of_bytes * 0x0102040810204080u >> 56) << i;
          }
        if (n - first < n_marks)
          bits &= (std::uint64_t(1) << (n - first)) - 1;
        for (; bits != 0; bits &= bits - 1)
          action(first + __builtin_ctzll(bits));
      }
  }
} // namespace mpm_granular

#endif
