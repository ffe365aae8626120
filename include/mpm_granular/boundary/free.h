#ifndef mpm_granular_boundary_free_h
#define mpm_granular_boundary_free_h

#include <mpm_granular/boundary/boundary_condition.h>

namespace mpm_granular::Boundary
{
  /// An open boundary: no force; points may leave.
  template <int dim>
  class Free : public BoundaryCondition<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;
  };
} // namespace mpm_granular::Boundary

#endif
