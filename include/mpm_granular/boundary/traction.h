#ifndef mpm_granular_boundary_traction_h
#define mpm_granular_boundary_traction_h

#include <mpm_granular/boundary/boundary_condition.h>
#include <mpm_granular/core/expression.h>

#include <optional>
#include <string>

namespace mpm_granular::Boundary
{
  /// A given force per area, a function of place and time (T10).
  template <int dim>
  class Traction : public BoundaryCondition<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    bool
    has_traction() const override
    {
      return true;
    }

    dealii::Tensor<1, dim>
    traction(const dealii::Point<dim> &place, const double time) const override;

  private:
    std::string text = dim == 2 ? "0; 0" : "0; 0; 0";
    mutable std::optional<Core::Expression<dim>> expression;
  };
} // namespace mpm_granular::Boundary

#endif
