#ifndef mpm_granular_boundary_coulomb_wall_h
#define mpm_granular_boundary_coulomb_wall_h

#include <mpm_granular/boundary/boundary_condition.h>

namespace mpm_granular::Boundary
{
  /// A wall that pushes but does not hold, with Coulomb friction (T34).
  template <int dim>
  class CoulombWall : public BoundaryCondition<dim>
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

    std::optional<double>
    contact_friction() const override
    {
      return friction;
    }

  private:
    double friction = 0.3;
  };
} // namespace mpm_granular::Boundary

#endif
