#ifndef mpm_granular_parameters_named_groups_h
#define mpm_granular_parameters_named_groups_h

#include <deal.II/base/parameter_handler.h>

#include <mpm_granular/parameters/documentation_handler.h>
#include <mpm_granular/parameters/pattern_text.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace mpm_granular::Parameters
{
  /**
   * Groups of entries with names of the user's own: materials, regions,
   * boundary conditions. The entry "Names" lists the names; each name has a
   * subsection.
   *
   * @tparam Group default-constructible, with add_parameters(prm).
   */
  template <class Group>
  class NamedGroups
  {
  public:
    explicit NamedGroups(std::vector<std::string> default_names)
      : names(std::move(default_names))
    {}

    /// Declares the entry that lists the names, and the groups they name now.
    void
    add_parameters(dealii::ParameterHandler &prm,
                   const std::string        &documentation)
    {
      prm.add_parameter("Names", names, documentation, ListOfNames());
      if (auto *all = dynamic_cast<DocumentationHandler *>(&prm))
        {
          const auto example = std::make_shared<Group>();
          all->keep(example);
          declare(prm, DocumentationHandler::any_name, *example);
          return;
        }
      for (const auto &name : names)
        declare(prm, name, groups[name]);
    }

    /// The names in the user's order.
    const std::vector<std::string> &
    all_names() const
    {
      return names;
    }

    const Group &
    operator[](const std::string &name) const
    {
      return groups.at(name);
    }

  private:
    static void
    declare(dealii::ParameterHandler &prm,
            const std::string        &name,
            Group                    &group)
    {
      prm.enter_subsection(name);
      group.add_parameters(prm);
      prm.leave_subsection();
    }

    std::vector<std::string>     names;
    std::map<std::string, Group> groups;
  };
} // namespace mpm_granular::Parameters

#endif
