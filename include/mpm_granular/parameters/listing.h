#ifndef mpm_granular_parameters_listing_h
#define mpm_granular_parameters_listing_h

#include <mpm_granular/parameters/entry.h>

#include <ostream>
#include <vector>

namespace mpm_granular::Parameters
{
  /// Forms in which entries are listed.
  enum class Style
  {
    parameter_file, ///< can be read again, with the texts as comments
    markdown        ///< tables for the documentation
  };

  /// Writes all @p entries with text, unit, allowed values and default.
  void
  write(const std::vector<Entry> &entries,
        std::ostream             &out,
        const Style               style);
} // namespace mpm_granular::Parameters

#endif
