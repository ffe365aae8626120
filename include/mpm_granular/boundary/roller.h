#ifndef mpm_granular_boundary_roller_h
#define mpm_granular_boundary_roller_h

#include <mpm_granular/boundary/boundary_condition.h>

namespace mpm_granular::Boundary
{
  /// A smooth wall that holds on: no velocity along the normal.
  template <int dim>
  class Roller : public BoundaryCondition<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    bool
    is_at_rest() const override
    {
      return true;
    }

    std::vector<dealii::Tensor<1, dim>>
    prescribed_directions(const dealii::Tensor<1, dim> &normal) const override;
  };
} // namespace mpm_granular::Boundary

#endif
