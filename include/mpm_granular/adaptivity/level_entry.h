#ifndef mpm_granular_adaptivity_level_entry_h
#define mpm_granular_adaptivity_level_entry_h

#include <deal.II/base/parameter_handler.h>

#include <mpm_granular/adaptivity/criterion.h>

#include <string>

namespace mpm_granular::Adaptivity
{
  /// Declares the entry "Level" of a criterion.
  /// @param text what it is the level of.
  inline void
  add_level_entry(dealii::ParameterHandler &prm,
                  unsigned int             &level,
                  const std::string        &text)
  {
    prm.add_parameter("Level",
                      level,
                      text + ". More than 'Maximum level' counts as that. "
                             "Units: none.",
                      dealii::Patterns::Integer(0, highest_level));
  }
} // namespace mpm_granular::Adaptivity

#endif
