#ifndef mpm_granular_adaptivity_criterion_h
#define mpm_granular_adaptivity_criterion_h

#include <mpm_granular/adaptivity/state.h>
#include <mpm_granular/core/registry.h>
#include <mpm_granular/parameters/parameter_group.h>

namespace mpm_granular::Adaptivity
{
  /// No cell is ever finer than this.
  inline constexpr unsigned int highest_level = 20;

  /**
   * Says how fine the mesh has to be, cell by cell. A cell gets the highest
   * level that any criterion wants, within the bounds of the section, and the
   * cells around it follow (Adaptation).
   *
   * A cell is refined if it wants a higher level than it has; a family, the
   * cells that one cell was divided into, is undone if all of them want a lower
   * one. A mesh comes to rest if a criterion follows the rule: where a cell
   * would want to be divided, one at least of the cells it is divided into
   * wants to stay.
   */
  template <int dim>
  class Criterion : public Parameters::ParameterGroup
  {
  public:
    /// Looks at the state as a whole, before wanted_level() is called for the
    /// cells. Collective.
    virtual void
    prepare(const State<dim> & /*state*/)
    {}

    /// The level wanted for a cell that this rank owns; what is above
    /// highest_level counts as that.
    virtual unsigned int
    wanted_level(const State<dim> &state, const unsigned int cell) const = 0;
  };

  template <int dim>
  using CriterionRegistry = Core::Registry<Criterion<dim>>;
} // namespace mpm_granular::Adaptivity

#endif
