#ifndef mpm_granular_parameters_refusal_h
#define mpm_granular_parameters_refusal_h

#include <mpm_granular/parameters/entry.h>
#include <mpm_granular/parameters/input_text.h>

#include <string>
#include <vector>

/*
 * The messages for input that is refused. All functions that are called
 * refuse_... throw InputError.
 */
namespace mpm_granular::Parameters
{
  /// Whether there are entries in the section @p path or below.
  bool
  is_section(const std::vector<Entry> &entries, const std::string &path);

  /// The value is not allowed for this entry.
  [[noreturn]] void
  refuse_value(const Entry &entry, const Assignment &assignment);

  /**
   * The entry does not exist.
   *
   * @param entries the entries there are.
   * @param documented those there would be with other choices, see
   *   documented_entries().
   */
  [[noreturn]] void
  refuse_entry(const std::vector<Entry> &entries,
               const std::vector<Entry> &documented,
               const Assignment         &assignment);

  /// The subsection does not exist; parameters as in refuse_entry().
  [[noreturn]] void
  refuse_section(const std::vector<Entry> &entries,
                 const std::vector<Entry> &documented,
                 const std::string        &path,
                 const std::string        &origin);
} // namespace mpm_granular::Parameters

#endif
