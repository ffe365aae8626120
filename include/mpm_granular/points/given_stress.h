#ifndef mpm_granular_points_given_stress_h
#define mpm_granular_points_given_stress_h

#include <mpm_granular/points/initial_state.h>

namespace mpm_granular::Points
{
  /// No stress at the start.
  template <int dim>
  class NoStress : public InitialStress<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    Stress<dim>
    stress(const dealii::Point<dim>     &place,
           const double                  density,
           const dealii::Tensor<1, dim> &gravity) const override;
  };

  /// A stress field given by functions of place.
  template <int dim>
  class GivenStress : public InitialStress<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    Stress<dim>
    stress(const dealii::Point<dim>     &place,
           const double                  density,
           const dealii::Tensor<1, dim> &gravity) const override;

  private:
    std::string text = dim == 2 ? "0; 0; 0; 0" : "0; 0; 0; 0; 0; 0";
    mutable std::optional<Core::Expression<dim>> expression;
  };
} // namespace mpm_granular::Points

#endif
