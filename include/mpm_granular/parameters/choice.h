#ifndef mpm_granular_parameters_choice_h
#define mpm_granular_parameters_choice_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>

#include <mpm_granular/core/registry.h>
#include <mpm_granular/parameters/documentation_handler.h>
#include <mpm_granular/parameters/named_groups.h>

#include <memory>
#include <string>
#include <typeinfo>

namespace mpm_granular::Parameters
{
  /**
   * One implementation of an interface, chosen by an entry of the parameter
   * file, with the entries of that implementation beside it.
   */
  template <class Interface>
  class Choice
  {
  public:
    /// Makes the implementation @p default_name, to be used until another one
    /// is read.
    explicit Choice(const std::string &default_name)
      : name(default_name)
      , made(default_name)
      , implementation(Core::Registry<Interface>::make(default_name))
    {}

    /**
     * Declares the entry @p entry that chooses, and the entries of what is
     * chosen now.
     */
    void
    add_parameters(dealii::ParameterHandler &prm,
                   const std::string        &entry,
                   const std::string        &documentation)
    {
      using Registry = Core::Registry<Interface>;
      prm.add_parameter(entry,
                        name,
                        documentation + Registry::documentation(),
                        dealii::Patterns::Selection(Registry::names()));
      if (made != name)
        {
          implementation = Registry::make(name);
          made           = name;
        }
      if (auto *all = dynamic_cast<DocumentationHandler *>(&prm))
        all->expand_once(typeid(Interface), [&] { document(*all, entry); });
      else
        implementation->add_parameters(prm);
    }

    const std::string &
    chosen_name() const
    {
      return name;
    }

    Interface &
    operator*() const
    {
      return *implementation;
    }

    Interface *
    operator->() const
    {
      return implementation.get();
    }

  private:
    /// Declares the entries of all implementations.
    void
    document(DocumentationHandler &prm, const std::string &entry)
    {
      for (const auto &[each, record] : Core::Registry<Interface>::records())
        {
          const std::shared_ptr<Interface> other = record.make();
          prm.keep(other);
          prm.enter_subsection(
            DocumentationHandler::section_of_choice(entry, each));
          (each == made ? *implementation : *other).add_parameters(prm);
          prm.leave_subsection();
        }
    }

    std::string                name;
    std::string                made;
    std::unique_ptr<Interface> implementation;
  };
} // namespace mpm_granular::Parameters

#endif
