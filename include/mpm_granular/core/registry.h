#ifndef mpm_granular_core_registry_h
#define mpm_granular_core_registry_h

#include <mpm_granular/core/exceptions.h>

#include <functional>
#include <map>
#include <memory>
#include <string>

namespace mpm_granular::Core
{
  /**
   * The implementations of one interface that can be chosen by name in the
   * parameter file. An implementation enters itself from its own source file
   * with a static Registry::Entry, so that adding one changes no other file.
   *
   * @tparam Interface an abstract class with a default-constructible set of
   *   implementations.
   */
  template <class Interface>
  class Registry
  {
  public:
    using Maker = std::function<std::unique_ptr<Interface>()>;

    struct Record
    {
      std::string documentation;
      Maker       make;
    };

    /// A static object of this type registers @p Implementation under a name.
    template <class Implementation>
    struct Entry
    {
      Entry(const std::string &name, const std::string &documentation)
      {
        records()[name] = {documentation,
                           [] { return std::make_unique<Implementation>(); }};
      }
    };

    /// All records, sorted by name.
    static std::map<std::string, Record> &
    records()
    {
      static std::map<std::string, Record> all;
      return all;
    }

    /// The names separated by @p separator, as dealii::Patterns::Selection
    /// takes them.
    static std::string
    names(const std::string &separator = "|")
    {
      std::string list;
      for (const auto &[name, record] : records())
        list += (list.empty() ? "" : separator) + name;
      return list;
    }

    /// One sentence per name, for the text of the entry that selects.
    static std::string
    documentation()
    {
      std::string text;
      for (const auto &[name, record] : records())
        text += " '" + name + "': " + record.documentation;
      return text;
    }

    /// A new object of the implementation @p name.
    static std::unique_ptr<Interface>
    make(const std::string &name)
    {
      const auto record = records().find(name);
      require(record != records().end(),
              "There is no '" + name + "'; valid names are " + names(", ") +
                ".");
      return record->second.make();
    }
  };
} // namespace mpm_granular::Core

#endif
