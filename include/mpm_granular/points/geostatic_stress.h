#ifndef mpm_granular_points_geostatic_stress_h
#define mpm_granular_points_geostatic_stress_h

#include <mpm_granular/points/initial_state.h>

namespace mpm_granular::Points
{
  /// The weight of what lies above, and K0 times it sideways (T26, the paper's
  /// eq. 22).
  template <int dim>
  class GeostaticStress : public InitialStress<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    Stress<dim>
    stress(const dealii::Point<dim>     &place,
           const double                  density,
           const dealii::Tensor<1, dim> &gravity) const override;

  private:
    double surface = 0.;  ///< [m]
    double ratio   = 0.5; ///< K0
  };
} // namespace mpm_granular::Points

#endif
