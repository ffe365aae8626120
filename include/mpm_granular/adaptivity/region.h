#ifndef mpm_granular_adaptivity_region_h
#define mpm_granular_adaptivity_region_h

#include <mpm_granular/adaptivity/criterion.h>
#include <mpm_granular/core/expression.h>

#include <optional>
#include <string>
#include <vector>

namespace mpm_granular::Adaptivity
{
  /// A level given as a function of place and time.
  template <int dim>
  class Region : public Criterion<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    void
    prepare(const State<dim> &state) override;

    unsigned int
    wanted_level(const State<dim>  &state,
                 const unsigned int cell) const override;

  private:
    std::string                                  text = "0";
    mutable std::optional<Core::Expression<dim>> expression;
    std::vector<unsigned int>                    of_nodes;
  };
} // namespace mpm_granular::Adaptivity

#endif
