#ifndef mpm_granular_core_exact_text_h
#define mpm_granular_core_exact_text_h

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>

namespace mpm_granular::Core
{
  /// The shortest text that reads back to exactly @p value, for files that other
  /// programs read; whole numbers without exponent.
  inline std::string
  exact_text(const double value)
  {
    constexpr double     largest_exact_integer = 9007199254740992.;
    std::array<char, 64> buffer;
    if (std::abs(value) < largest_exact_integer && std::trunc(value) == value)
      return std::string(buffer.data(),
                         std::snprintf(buffer.data(),
                                       buffer.size(),
                                       "%.0f",
                                       value + 0.)); // + 0 turns -0 into 0
    const auto result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return std::string(buffer.data(), result.ptr);
  }
} // namespace mpm_granular::Core

#endif
