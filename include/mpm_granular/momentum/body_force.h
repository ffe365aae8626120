#ifndef mpm_granular_momentum_body_force_h
#define mpm_granular_momentum_body_force_h

#include <deal.II/base/tensor.h>

#include <mpm_granular/core/expression.h>
#include <mpm_granular/parameters/parameter_group.h>

#include <optional>
#include <string>

namespace mpm_granular::Momentum
{
  /// Gravity, or any force per mass that is the same everywhere, as a function
  /// of time (T10).
  template <int dim>
  class BodyForce : public Parameters::ParameterGroup
  {
  public:
    BodyForce();

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    /// Force per mass at @p time [m/s^2].
    dealii::Tensor<1, dim>
    value(const double time) const;

  private:
    dealii::Tensor<1, dim>                       gravity;
    std::string                                  factor = "1";
    mutable std::optional<Core::Expression<dim>> factor_expression;
  };
} // namespace mpm_granular::Momentum

#endif
