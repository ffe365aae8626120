#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/parameters/changes.h>

#include <algorithm>

namespace mpm_granular::Parameters
{
  namespace
  {
    bool
    may_change(const Entry &entry, const std::vector<std::string> &changeable)
    {
      return std::any_of(changeable.begin(),
                         changeable.end(),
                         [&](const std::string &path) {
                           return (entry.path() + "/").rfind(path + "/", 0) ==
                                  0;
                         });
    }



    /// The value as a message shows it.
    std::string
    value_of(const std::vector<Entry> &entries, const std::string &path)
    {
      const Entry *entry = find_entry(entries, path);
      return entry == nullptr ? "nothing" : "'" + entry->value + "'";
    }
  } // namespace



  void
  refuse_changes(const std::vector<Entry>       &before,
                 const std::vector<Entry>       &now,
                 const std::vector<std::string> &changeable,
                 const std::string              &why_not)
  {
    // What is there only before differs as well.
    for (const auto *entries : {&now, &before})
      for (const auto &entry : *entries)
        {
          const std::string old_value = value_of(before, entry.path());
          const std::string new_value = value_of(now, entry.path());
          require(old_value == new_value || may_change(entry, changeable),
                  "'" + entry.path() + "' cannot be changed from " + old_value +
                    " to " + new_value + " " + why_not);
        }
  }
} // namespace mpm_granular::Parameters
