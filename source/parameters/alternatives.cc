#include <deal.II/base/utilities.h>

#include <mpm_granular/parameters/alternatives.h>
#include <mpm_granular/parameters/documentation_handler.h>

#include <algorithm>

namespace mpm_granular::Parameters
{
  namespace
  {
    using Names = std::vector<std::string>;

    Names
    split(const std::string &path)
    {
      return dealii::Utilities::split_string_list(path, '/');
    }



    /// Whether @p names begins with @p path; any_name is equal to every name.
    bool
    begins_with(const Names &names, const Names &path)
    {
      return names.size() >= path.size() &&
             std::equal(path.begin(),
                        path.end(),
                        names.begin(),
                        [](const std::string &one, const std::string &name) {
                          return one == name ||
                                 name == DocumentationHandler::any_name;
                        });
    }



    /// The path of a documented entry in a file, where choices are no sections.
    Names
    path_in_file(const Entry &entry)
    {
      Names names;
      for (const auto &name : entry.section)
        if (!DocumentationHandler::is_section_of_choice(name))
          names.push_back(name);
      names.push_back(entry.name);
      return names;
    }



    /// Calls @p action for every choice, and every choice of names, that a
    /// documented entry depends on within the first @p depth names of its path:
    /// with the path of the entry that chooses, and what it has to be.
    template <class Function>
    void
    for_each_condition(const Entry      &entry,
                       const std::size_t depth,
                       const Function   &action)
    {
      Names path;
      for (const auto &name : entry.section)
        {
          if (path.size() == depth)
            return;
          Names chooser = path;
          if (DocumentationHandler::is_section_of_choice(name))
            {
              chooser.push_back(name.substr(0, name.find(" = ")));
              action(chooser, name);
              continue;
            }
          if (name == DocumentationHandler::any_name)
            {
              chooser.push_back("Names");
              action(chooser, name);
            }
          path.push_back(name);
        }
    }
  } // namespace



  std::vector<std::string>
  choices_that_have(const std::vector<Entry> &documented,
                    const std::string        &path)
  {
    const Names names = split(path);
    Names       choices;
    for (const auto &entry : documented)
      if (begins_with(path_in_file(entry), names))
        {
          std::string innermost;
          for_each_condition(entry,
                             names.size(),
                             [&](const Names &, const std::string &condition) {
                               if (condition != DocumentationHandler::any_name)
                                 innermost = condition;
                             });
          if (!innermost.empty() &&
              std::find(choices.begin(), choices.end(), innermost) ==
                choices.end())
            choices.push_back(innermost);
        }
    return choices;
  }



  bool
  is_displaced(const std::vector<Entry>      &documented,
               const std::string             &path,
               const std::vector<Assignment> &overrides)
  {
    const Names names     = split(path);
    bool        displaced = false;
    for (const auto &entry : documented)
      if (begins_with(path_in_file(entry), names))
        for_each_condition(
          entry, names.size(), [&](const Names &chooser, const std::string &) {
            for (const auto &override : overrides)
              if (begins_with(chooser, split(override.path)) &&
                  chooser.size() == split(override.path).size())
                displaced = true;
          });
    return displaced;
  }
} // namespace mpm_granular::Parameters
