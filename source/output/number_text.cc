#include <mpm_granular/output/number_text.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace mpm_granular::Output
{
  namespace
  {
    template <typename... Arguments>
    std::string
    print(const char *format, const Arguments... arguments)
    {
      std::array<char, 64> buffer;
      const int            n_characters =
        std::snprintf(buffer.data(), buffer.size(), format, arguments...);
      return std::string(buffer.data(), n_characters);
    }
  } // namespace



  std::string
  short_text(const double value, const unsigned int n_digits)
  {
    return print("%.*g", static_cast<int>(n_digits), value + 0.);
  }



  std::string
  count_text(const double count)
  {
    if (!std::isfinite(count) || std::abs(count) >= 1e15)
      return short_text(count);
    std::string text     = print("%.0f", std::abs(count));
    const int   n_digits = text.size();
    for (int position = n_digits - 3; position > 0; position -= 3)
      text.insert(position, ",");
    return (count < 0. ? "-" : "") + text;
  }



  std::string
  duration_text(const double seconds)
  {
    if (!std::isfinite(seconds) || seconds < 0.)
      return "unknown";
    if (seconds < 59.95)
      return print(seconds < 9.995 ? "%.2f s" : "%.1f s", seconds);
    const double whole = std::round(seconds);
    if (whole < 3600.)
      return print("%.0f min %02.0f s",
                   std::floor(whole / 60.),
                   std::fmod(whole, 60.));
    const double minutes = std::round(seconds / 60.);
    if (minutes < 48 * 60.)
      return print("%.0f h %02.0f min",
                   std::floor(minutes / 60.),
                   std::fmod(minutes, 60.));
    return print("%.1f days", seconds / 86400.);
  }



  std::string
  bytes_text(const double bytes)
  {
    const std::array<const char *, 5> units{{"B", "kB", "MB", "GB", "TB"}};
    double                            value = bytes;
    unsigned int                      unit  = 0;
    for (; value >= 999.5 && unit + 1 < units.size(); ++unit)
      value /= 1000.;
    return short_text(value) + " " + units[unit];
  }
} // namespace mpm_granular::Output
