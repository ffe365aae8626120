#ifndef mpm_granular_parameters_parameter_file_h
#define mpm_granular_parameters_parameter_file_h

#include <mpm_granular/parameters/entry.h>
#include <mpm_granular/parameters/input_text.h>
#include <mpm_granular/parameters/parameter_group.h>

#include <string>
#include <vector>

namespace mpm_granular::Parameters
{
  /**
   * Reads a parameter file into the variables of @p group. Which entries exist
   * may depend on values (see ParameterGroup::add_parameters): the values are
   * read again and again until the declared entries do not change any more.
   *
   * @param group not checked; see check().
   * @param source the parameter file; without a name: none.
   * @param overrides "Section/Sub/Entry=value", stronger than the file. What
   *   the file says for a choice that an override changes to another one is
   *   passed over.
   * @return the entries, with the values used and the defaults.
   * @throws InputError with file and line for the first entry whose value is
   *   not allowed, or else the first one that does not exist.
   */
  std::vector<Entry>
  read(ParameterGroup                 &group,
       const InputSource              &source,
       const std::vector<std::string> &overrides = {});

  /// ParameterGroup::check(), with the name of the file in front of messages.
  void
  check(const ParameterGroup &group, const std::string &file);

  /**
   * All entries @p group can have, whatever is chosen: those of an
   * implementation in subsections like "Law = elastic", those of named groups
   * in the subsection "<name>".
   */
  std::vector<Entry>
  documented_entries(ParameterGroup &group);
} // namespace mpm_granular::Parameters

#endif
