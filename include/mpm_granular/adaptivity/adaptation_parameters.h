#ifndef mpm_granular_adaptivity_adaptation_parameters_h
#define mpm_granular_adaptivity_adaptation_parameters_h

#include <mpm_granular/adaptivity/criterion.h>
#include <mpm_granular/parameters/choice.h>
#include <mpm_granular/parameters/named_groups.h>

namespace mpm_granular::Adaptivity
{
  /// A criterion of the parameter file.
  template <int dim>
  struct CriterionSetting : Parameters::ParameterGroup
  {
    CriterionSetting();

    Parameters::Choice<Criterion<dim>> criterion;

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;
  };

  /// When and how far the mesh is adapted, and by which criteria.
  template <int dim>
  struct AdaptationParameters : Parameters::ParameterGroup
  {
    AdaptationParameters();

    Parameters::NamedGroups<CriterionSetting<dim>> criteria;

    unsigned int minimum_level         = 0;
    unsigned int maximum_level         = 2;
    unsigned int maximum_n_cells       = 0;   ///< 0: any number
    unsigned int interval              = 100; ///< steps; 0: any number
    double       interval_displacement = 0.5; ///< in cell sizes; 0: any
    unsigned int n_buffer_layers       = 1;
    unsigned int n_kept_layers         = 1;
    unsigned int split_below           = 0; ///< points per cell
    unsigned int merge_above           = 0; ///< points per cell; 0: never

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    /// Whether there is any criterion.
    bool
    is_wanted() const
    {
      return !criteria.all_names().empty();
    }
  };
} // namespace mpm_granular::Adaptivity

#endif
