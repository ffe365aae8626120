#ifndef mpm_granular_parameters_changes_h
#define mpm_granular_parameters_changes_h

#include <mpm_granular/parameters/entry.h>

#include <string>
#include <vector>

namespace mpm_granular::Parameters
{
  /**
   * Refuses that entries differ, unless they may.
   *
   * @param before,now all entries with the values used.
   * @param changeable paths of entries, or of sections with all that is in
   *   them, that may differ.
   * @param why_not the end of the message: "'Entry' cannot be changed from '1'
   *   to '2' " and this.
   * @throws InputError with the first entry that differs and may not.
   */
  void
  refuse_changes(const std::vector<Entry>       &before,
                 const std::vector<Entry>       &now,
                 const std::vector<std::string> &changeable,
                 const std::string              &why_not);
} // namespace mpm_granular::Parameters

#endif
