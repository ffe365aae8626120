#ifndef mpm_granular_parameters_documentation_handler_h
#define mpm_granular_parameters_documentation_handler_h

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <set>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

namespace mpm_granular::Parameters
{
  /**
   * A ParameterHandler in which everything that can be declared is declared,
   * for the documentation: Choice adds the entries of every implementation, in
   * subsections called "Entry = name", and NamedGroups a group called @ref
   * any_name. Nothing is read with it.
   */
  class DocumentationHandler : public dealii::ParameterHandler
  {
  public:
    /// Stands for the names that the user chooses.
    static inline const std::string any_name = "<name>";

    /// The subsection with the entries of an implementation.
    static std::string
    section_of_choice(const std::string &entry, const std::string &name)
    {
      return entry + " = " + name;
    }

    /// Whether a subsection was made by section_of_choice().
    static bool
    is_section_of_choice(const std::string &section)
    {
      return section.find(" = ") != std::string::npos;
    }

    /**
     * Declares with @p declare the implementations of the interface @p type,
     * except where that happens inside itself (say, a law that modifies another
     * one).
     */
    template <class Function>
    void
    expand_once(const std::type_index type, const Function &declare)
    {
      if (!open.insert(type).second)
        return;
      declare();
      open.erase(type);
    }

    /// Keeps what entries are bound to as long as the entries.
    void
    keep(std::shared_ptr<void> object)
    {
      kept.push_back(std::move(object));
    }

  private:
    std::set<std::type_index>          open;
    std::vector<std::shared_ptr<void>> kept;
  };



  /**
   * Declares entries that exist only where another entry has a certain value.
   *
   * @param prm in the subsection of both.
   * @param entry the other entry.
   * @param needed the value it must have.
   * @param value the value it has.
   * @param declare declares the entries, called if both are equal, and for the
   *   documentation.
   */
  template <class Function>
  void
  only_with(dealii::ParameterHandler &prm,
            const std::string        &entry,
            const std::string        &needed,
            const std::string        &value,
            const Function           &declare)
  {
    if (dynamic_cast<DocumentationHandler *>(&prm) != nullptr)
      {
        prm.enter_subsection(
          DocumentationHandler::section_of_choice(entry, needed));
        declare();
        prm.leave_subsection();
      }
    else if (value == needed)
      declare();
  }
} // namespace mpm_granular::Parameters

#endif
