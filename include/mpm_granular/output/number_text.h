#ifndef mpm_granular_output_number_text_h
#define mpm_granular_output_number_text_h

#include <string>

namespace mpm_granular::Output
{
  /// @p value with @p n_digits significant digits, for people: 0.00123, 12.3,
  /// 1.23e+08.
  std::string
  short_text(const double value, const unsigned int n_digits = 3);

  /// @p count with separators between thousands: 1,234,567.
  std::string
  count_text(const double count);

  /// A duration of @p seconds for people: 0.52 s, 12.3 s, 4 min 05 s, 3 h 20 min.
  std::string
  duration_text(const double seconds);

  /// An amount of memory for people: 12.3 MB.
  std::string
  bytes_text(const double bytes);
} // namespace mpm_granular::Output

#endif
