#include <deal.II/base/exceptions.h>
#include <deal.II/base/parameter_handler.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/parameters/alternatives.h>
#include <mpm_granular/parameters/documentation_handler.h>
#include <mpm_granular/parameters/input_text.h>
#include <mpm_granular/parameters/name_distance.h>
#include <mpm_granular/parameters/parameter_file.h>
#include <mpm_granular/parameters/refusal.h>

#include <algorithm>
#include <map>

namespace mpm_granular::Parameters
{
  using dealii::ParameterHandler;

  namespace
  {
    /// Whether two passes declared the same.
    bool
    declared_the_same(const std::vector<Entry> &first,
                      const std::vector<Entry> &second)
    {
      return std::equal(first.begin(),
                        first.end(),
                        second.begin(),
                        second.end(),
                        [](const Entry &one, const Entry &other) {
                          return one.path() == other.path() &&
                                 one.default_value == other.default_value &&
                                 one.pattern == other.pattern;
                        });
    }



    /// Sets an entry. @return whether its pattern allows the value.
    bool
    try_to_set(ParameterHandler  &prm,
               const Entry       &entry,
               const std::string &value)
    {
      // Patterns of unsigned numbers let negative ones pass, which wrap around.
      if (entry.pattern.find("[Integer]") != std::string::npos &&
          value.find('-') != std::string::npos)
        return false;
      try
        {
          set_value(prm, entry, value);
        }
      catch (const dealii::ExceptionBase &)
        {
          return false;
        }
      return true;
    }



    /// Sets what is declared and allowed, passes over the rest.
    void
    set_what_fits(ParameterHandler         &prm,
                  const std::vector<Entry> &entries,
                  const InputText          &text)
    {
      for (const auto *assignments : {&text.assignments, &text.overrides})
        for (const auto &assignment : *assignments)
          if (const Entry *entry = find_entry(entries, assignment.path))
            try_to_set(prm, *entry, assignment.value);
    }



    /// Sets everything, refuses what is declared and not allowed.
    void
    set_or_refuse(ParameterHandler         &prm,
                  const std::vector<Entry> &entries,
                  const InputText          &text)
    {
      for (const auto *assignments : {&text.assignments, &text.overrides})
        for (const auto &assignment : *assignments)
          if (const Entry *entry = find_entry(entries, assignment.path))
            if (!try_to_set(prm, *entry, assignment.value))
              refuse_value(*entry, assignment);
    }



    /**
     * Refuses what is not declared, except in the file what an override made
     * void by another choice: a file may be used with --set "Law=elastic"
     * although it has entries of the law that it chose itself.
     */
    void
    refuse_unknown(const std::vector<Entry> &entries,
                   const std::vector<Entry> &documented,
                   const InputText          &text)
    {
      for (const auto &section : text.sections)
        if (!is_section(entries, section.path) &&
            !is_displaced(documented, section.path, text.overrides))
          refuse_section(entries, documented, section.path, section.origin);
      for (const auto &assignment : text.assignments)
        if (!find_entry(entries, assignment.path) &&
            !is_displaced(documented, assignment.path, text.overrides))
          refuse_entry(entries, documented, assignment);
      for (const auto &assignment : text.overrides)
        if (!find_entry(entries, assignment.path))
          refuse_entry(entries, documented, assignment);
    }
  } // namespace



  std::vector<Entry>
  read(ParameterGroup                 &group,
       const InputSource              &source,
       const std::vector<std::string> &overrides)
  {
    const InputText text = read_input_text(source, overrides);

    std::map<std::string, std::string> defaults;
    std::vector<Entry>                 before;
    // Every pass settles one more level of choices within choices.
    const unsigned int n_passes = 50;
    for (unsigned int pass = 0; pass < n_passes; ++pass)
      {
        ParameterHandler prm;
        group.add_parameters(prm);
        std::vector<Entry> entries = entries_of(prm);
        for (const auto &entry : entries)
          defaults.insert({entry.path(), entry.default_value});

        if (!declared_the_same(before, entries))
          {
            set_what_fits(prm, entries, text);
            before = entries;
            continue;
          }

        // Before the values are set: declaring an entry rounds its value.
        const auto documented = documented_entries(group);
        set_or_refuse(prm, entries, text);
        refuse_unknown(entries, documented, text);
        const auto missing = required_but_not_set(prm);
        require(missing.empty(),
                source.name + ": " + quoted_list(missing) + " must be set.");
        entries = entries_of(prm);
        for (auto &entry : entries)
          entry.default_value = defaults.at(entry.path());
        return entries;
      }
    throw InputError(source.name +
                     ": the entries depend on each other in a circle.");
  }



  void
  check(const ParameterGroup &group, const std::string &file)
  {
    try
      {
        group.check();
      }
    catch (const InputError &error)
      {
        throw InputError(file + ": " + error.what());
      }
  }



  std::vector<Entry>
  documented_entries(ParameterGroup &group)
  {
    DocumentationHandler prm;
    group.add_parameters(prm);
    return entries_of(prm);
  }
} // namespace mpm_granular::Parameters
