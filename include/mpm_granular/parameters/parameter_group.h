#ifndef mpm_granular_parameters_parameter_group_h
#define mpm_granular_parameters_parameter_group_h

#include <deal.II/base/parameter_handler.h>

namespace mpm_granular::Parameters
{
  /**
   * Something with entries in the parameter file: a module's settings, a chosen
   * plugin, or all of them together.
   */
  class ParameterGroup
  {
  public:
    virtual ~ParameterGroup() = default;

    /**
     * Declares the entries and binds them to this object's variables
     * (ParameterHandler::add_parameter). The range belongs into the pattern
     * (see also pattern_text.h), the unit to the end of the text: "Units: Pa.".
     * Messages and the documentation take both from there.
     *
     * Which entries there are may depend on values read before (names of
     * materials, the chosen law): reading repeats until it does not change any
     * more. Only entries that are used are declared, so an entry that has no
     * effect is an error, as a misspelt one.
     *
     * deal.II keeps six digits of a default, so defaults should need no more.
     */
    virtual void
    add_parameters(dealii::ParameterHandler &prm) = 0;

    /// Throws InputError where the values cannot be right together.
    virtual void
    check() const
    {}
  };
} // namespace mpm_granular::Parameters

#endif
