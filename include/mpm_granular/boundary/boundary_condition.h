#ifndef mpm_granular_boundary_boundary_condition_h
#define mpm_granular_boundary_boundary_condition_h

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <mpm_granular/core/registry.h>
#include <mpm_granular/parameters/parameter_group.h>

#include <optional>
#include <vector>

namespace mpm_granular::Boundary
{
  /**
   * What holds or loads the material at a part of the mesh's boundary. A
   * condition prescribes velocity components, or gives a traction, or does
   * nothing.
   */
  template <int dim>
  class BoundaryCondition : public Parameters::ParameterGroup
  {
  public:
    /// The directions in which the velocity is prescribed where the outward
    /// normal is @p normal; unit vectors.
    virtual std::vector<dealii::Tensor<1, dim>>
    prescribed_directions(const dealii::Tensor<1, dim> & /*normal*/) const
    {
      return {};
    }

    /// If the prescribed directions are those of a wall that pushes only, along
    /// its outward normal: the coefficient of its Coulomb friction.
    virtual std::optional<double>
    contact_friction() const
    {
      return {};
    }

    /// Whether velocity() is always zero, so that it need not be asked for.
    virtual bool
    is_at_rest() const
    {
      return false;
    }

    /// The velocity whose components are prescribed, over the step from @p time
    /// to @p time + @p time_step [m/s].
    virtual dealii::Tensor<1, dim>
    velocity(const dealii::Point<dim> & /*place*/,
             const double /*time*/,
             const double /*time_step*/) const
    {
      return {};
    }

    /// Whether there is a traction at all.
    virtual bool
    has_traction() const
    {
      return false;
    }

    /// Force per area on the material [Pa].
    virtual dealii::Tensor<1, dim>
    traction(const dealii::Point<dim> & /*place*/, const double /*time*/) const
    {
      return {};
    }
  };

  template <int dim>
  using BoundaryConditionRegistry = Core::Registry<BoundaryCondition<dim>>;
} // namespace mpm_granular::Boundary

#endif
