#ifndef mpm_granular_parameters_entry_h
#define mpm_granular_parameters_entry_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace mpm_granular::Parameters
{
  /// A declared entry of the parameter file.
  struct Entry
  {
    std::vector<std::string> section; ///< subsections from the outermost one
    std::string              name;
    std::string              value;
    std::string              default_value;
    std::string              documentation;
    std::string              pattern; ///< PatternBase::description()

    /// Section/Sub/Entry, as --set takes it.
    std::string
    path() const;
  };

  /// Section/Sub of a list of subsections.
  std::string
  joined(const std::vector<std::string> &section);

  /// All entries of @p prm in the order of their declaration, without aliases.
  std::vector<Entry>
  entries_of(const dealii::ParameterHandler &prm);

  /// Paths of the entries that were declared as having to be set, and are not.
  std::vector<std::string>
  required_but_not_set(const dealii::ParameterHandler &prm);

  /// The entry with a path, or a null pointer.
  const Entry *
  find_entry(const std::vector<Entry> &entries, const std::string &path);

  /// Sets @p entry of @p prm to @p value; prm is at its top level.
  void
  set_value(dealii::ParameterHandler &prm,
            const Entry              &entry,
            const std::string        &value);
} // namespace mpm_granular::Parameters

#endif
