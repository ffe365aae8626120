#ifndef mpm_granular_points_initial_state_h
#define mpm_granular_points_initial_state_h

#include <deal.II/base/point.h>

#include <mpm_granular/core/expression.h>
#include <mpm_granular/core/registry.h>
#include <mpm_granular/core/stress_layout.h>
#include <mpm_granular/parameters/choice.h>
#include <mpm_granular/parameters/parameter_group.h>
#include <mpm_granular/points/point_arrays.h>

#include <optional>
#include <string>

namespace mpm_granular::Points
{
  /// The stress of points at the start, when nothing is displaced yet.
  template <int dim>
  class InitialStress : public Parameters::ParameterGroup
  {
  public:
    /**
     * @param place of the point [m].
     * @param density of its material [kg/m^3].
     * @param gravity [m/s^2].
     * @return Cauchy stress, tension > 0 [Pa].
     */
    virtual Stress<dim>
    stress(const dealii::Point<dim>     &place,
           const double                  density,
           const dealii::Tensor<1, dim> &gravity) const = 0;
  };

  template <int dim>
  using InitialStressRegistry = Core::Registry<InitialStress<dim>>;

  /// Velocity and stress at the start.
  template <int dim>
  struct InitialState : Parameters::ParameterGroup
  {
    InitialState();

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    /// Sets velocity and stress of point @p p.
    void
    apply(PointArrays<dim>             &points,
          const std::size_t             p,
          const double                  density,
          const dealii::Tensor<1, dim> &gravity) const;

    /// The gradient of the initial velocity at a place, by differences over
    /// @p length, which are exact for linear velocities [1/s].
    dealii::Tensor<2, dim>
    velocity_gradient(const dealii::Point<dim> &place,
                      const double              length) const;

  private:
    std::string velocity = dim == 2 ? "0; 0" : "0; 0; 0";
    Parameters::Choice<InitialStress<dim>>       stress;
    mutable std::optional<Core::Expression<dim>> velocity_expression;
  };
} // namespace mpm_granular::Points

#endif
