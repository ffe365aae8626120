#ifndef mpm_granular_materials_separation_rule_h
#define mpm_granular_materials_separation_rule_h

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace mpm_granular::Materials
{
  /// What becomes of the gap of material that has separated (T7).
  class SeparationRule
  {
  public:
    SeparationRule();

    /// Declares and binds 'Separation' and what goes with it.
    void
    add_parameters(dealii::ParameterHandler &prm);

    /// The upper limit of the logarithm of the volume ratio of an open point:
    /// infinite for 'track', 0 for 'reset' [-].
    double
    largest_gap() const
    {
      return limit;
    }

  private:
    /// From the entries; called whenever one of them is set.
    void
    set_limit();

    std::string rule = "track";
    double      cap  = 0.05;
    double      limit;
  };
} // namespace mpm_granular::Materials

#endif
