#ifndef mpm_granular_parameters_alternatives_h
#define mpm_granular_parameters_alternatives_h

#include <mpm_granular/parameters/entry.h>
#include <mpm_granular/parameters/input_text.h>

#include <string>
#include <vector>

/*
 * What there would be if other choices were made, from documented_entries().
 */
namespace mpm_granular::Parameters
{
  /**
   * The choices, as "Law = elastic", with one of which the entry or subsection
   * @p path exists, whatever else is chosen.
   */
  std::vector<std::string>
  choices_that_have(const std::vector<Entry> &documented,
                    const std::string        &path);

  /**
   * Whether the entry or subsection @p path may have existed before @p
   * overrides made another choice, or another list of names.
   */
  bool
  is_displaced(const std::vector<Entry>      &documented,
               const std::string             &path,
               const std::vector<Assignment> &overrides);
} // namespace mpm_granular::Parameters

#endif
