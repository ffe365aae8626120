#include <deal.II/base/utilities.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/parameters/alternatives.h>
#include <mpm_granular/parameters/name_distance.h>
#include <mpm_granular/parameters/pattern_text.h>
#include <mpm_granular/parameters/refusal.h>

#include <algorithm>

namespace mpm_granular::Parameters
{
  namespace
  {
    using Names = std::vector<std::string>;

    void
    add_once(Names &names, const std::string &name)
    {
      if (std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
    }



    Names
    split(const std::string &path)
    {
      return dealii::Utilities::split_string_list(path, '/');
    }



    Names
    entries_in(const std::vector<Entry> &entries, const std::string &section)
    {
      Names names;
      for (const auto &entry : entries)
        if (joined(entry.section) == section)
          names.push_back(entry.name);
      return names;
    }



    /// Names of the subsections directly in @p section.
    Names
    sections_in(const std::vector<Entry> &entries, const Names &section)
    {
      Names names;
      for (const auto &entry : entries)
        if (entry.section.size() > section.size() &&
            std::equal(section.begin(), section.end(), entry.section.begin()))
          add_once(names, entry.section[section.size()]);
      return names;
    }



    std::string
    in_section(const std::string &section)
    {
      return section.empty() ? "outside of all subsections" :
                               "in '" + section + "'";
    }



    std::string
    list_of(const std::string &what, const Names &names)
    {
      return names.empty() ?
               " There are no " + what + "." :
               " The " + what + " are " + quoted_list(names) + ".";
    }
  } // namespace



  bool
  is_section(const std::vector<Entry> &entries, const std::string &path)
  {
    return std::any_of(entries.begin(), entries.end(), [&](const Entry &entry) {
      return (entry.path() + "/").rfind(path + "/", 0) == 0 &&
             entry.path() != path;
    });
  }



  void
  refuse_value(const Entry &entry, const Assignment &assignment)
  {
    const std::string unit = unit_in(entry.documentation);
    throw InputError(assignment.origin + ": '" + entry.path() +
                     "' cannot be '" + assignment.value + "': it must be " +
                     allowed_values(entry.pattern) +
                     (unit.empty() ? "" : " (in " + unit + ")") + "." +
                     hint_for(assignment.value, entry.pattern, unit));
  }



  void
  refuse_section(const std::vector<Entry> &entries,
                 const std::vector<Entry> &documented,
                 const std::string        &path,
                 const std::string        &origin)
  {
    // The outermost subsection that does not exist is the one to speak of.
    Names       parent;
    const Names all     = split(path);
    std::size_t missing = 0;
    for (; missing + 1 < all.size(); ++missing)
      {
        Names inner = parent;
        inner.push_back(all[missing]);
        if (!is_section(entries, joined(inner)))
          break;
        parent = inner;
      }
    const std::string name = all[missing];
    Names             full = parent;
    full.push_back(name);

    std::string message = origin + ": There is no subsection '" + name + "' " +
                          in_section(joined(parent)) + ".";
    const Names       siblings = sections_in(entries, parent);
    const Names       choices  = choices_that_have(documented, joined(full));
    const std::string similar  = did_you_mean(name, siblings);
    Names             named    = parent;
    named.push_back("Names");
    if (!choices.empty())
      message += " It exists only with " + quoted_list(choices) + ".";
    else if (!similar.empty())
      message += similar;
    else if (const Entry *names = find_entry(entries, joined(named)))
      message += " '" + names->path() + "' names " +
                 (names->value.empty() ? "nothing" : "'" + names->value + "'") +
                 "; add '" + name + "' there to have one.";
    else
      message += list_of("subsections", siblings);
    throw InputError(message);
  }



  void
  refuse_entry(const std::vector<Entry> &entries,
               const std::vector<Entry> &documented,
               const Assignment         &assignment)
  {
    Names             path = split(assignment.path);
    const std::string name = path.empty() ? "" : path.back();
    const Names section(path.begin(), path.end() - (path.empty() ? 0 : 1));
    if (!section.empty() && !is_section(entries, joined(section)))
      refuse_section(entries, documented, joined(section), assignment.origin);

    std::string message = assignment.origin + ": There is no entry '" + name +
                          "' " + in_section(joined(section)) + ".";
    const Names       siblings = entries_in(entries, joined(section));
    const Names       choices  = choices_that_have(documented, assignment.path);
    const std::string similar  = did_you_mean(name, siblings);
    Names             elsewhere;
    for (const auto &entry : entries)
      if (entry.name == name)
        elsewhere.push_back(entry.path());

    if (!choices.empty())
      message += " It exists only with " + quoted_list(choices) + ".";
    else if (!similar.empty())
      message += similar;
    else if (!elsewhere.empty())
      message += " Did you mean " + quoted_list(elsewhere) + "?";
    else
      message += list_of("entries", siblings);
    throw InputError(message);
  }
} // namespace mpm_granular::Parameters
