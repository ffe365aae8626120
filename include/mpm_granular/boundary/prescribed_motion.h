#ifndef mpm_granular_boundary_prescribed_motion_h
#define mpm_granular_boundary_prescribed_motion_h

#include <mpm_granular/boundary/boundary_condition.h>
#include <mpm_granular/core/expression.h>

#include <optional>
#include <string>
#include <vector>

namespace mpm_granular::Boundary
{
  /**
   * Chosen components of the velocity are given: what a velocity and a
   * displacement as functions of place and time have in common.
   */
  template <int dim>
  class PrescribedMotion : public BoundaryCondition<dim>
  {
  public:
    explicit PrescribedMotion(const std::string &quantity,
                              const std::string &unit);

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    std::vector<dealii::Tensor<1, dim>>
    prescribed_directions(const dealii::Tensor<1, dim> &normal) const override;

  protected:
    /// The given quantity.
    dealii::Tensor<1, dim>
    value(const dealii::Point<dim> &place, const double time) const;

  private:
    const std::string        quantity;
    const std::string        unit;
    std::string              text = dim == 2 ? "0; 0" : "0; 0; 0";
    std::vector<std::string> components;
    mutable std::optional<Core::Expression<dim>> expression;
  };

  /// Velocity components given as functions of place and time.
  template <int dim>
  class PrescribedVelocity : public PrescribedMotion<dim>
  {
  public:
    PrescribedVelocity();

    dealii::Tensor<1, dim>
    velocity(const dealii::Point<dim> &place,
             const double              time,
             const double              time_step) const override;
  };

  /// Displacement components given as functions of place and time; the velocity
  /// over a step is their difference quotient, so that displacements are exact.
  template <int dim>
  class PrescribedDisplacement : public PrescribedMotion<dim>
  {
  public:
    PrescribedDisplacement();

    dealii::Tensor<1, dim>
    velocity(const dealii::Point<dim> &place,
             const double              time,
             const double              time_step) const override;
  };
} // namespace mpm_granular::Boundary

#endif
