#include <mpm_granular/points/geostatic_stress.h>

#include <algorithm>

namespace mpm_granular::Points
{
  using namespace dealii;

  template <int dim>
  void
  GeostaticStress<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Surface level",
                      surface,
                      "Height of the horizontal surface, against gravity from "
                      "the origin; no stress above it. Units: m.");
    prm.add_parameter(
      "K0",
      ratio,
      "Ratio of horizontal to vertical stress. Elastic at rest "
      "nu/(1 - nu); the cone of slope m admits (3 - m)/(3 + 2m) "
      "and more. Units: -.",
      Patterns::Double(0.));
  }

  template <int dim>
  Stress<dim>
  GeostaticStress<dim>::stress(const Point<dim>     &place,
                               const double          density,
                               const Tensor<1, dim> &gravity) const
  {
    Stress<dim>  result{};
    const double strength = gravity.norm();
    if (strength == 0.)
      return result;
    const Tensor<1, dim> up       = -gravity / strength;
    const double         depth    = std::max(0., surface - up * place);
    const double         vertical = -density * strength * depth;
    for (unsigned int s = 0; s < n_stress<dim>; ++s)
      {
        const unsigned int i = stress_index[s][0], j = stress_index[s][1];
        const double       along = i < dim && j < dim ? up[i] * up[j] : 0.;
        result[s] = vertical * (along + ratio * ((i == j ? 1. : 0.) - along));
      }
    return result;
  }

  template class GeostaticStress<2>;
  template class GeostaticStress<3>;

  namespace
  {
    const std::string documentation =
      "the weight of what lies above, and K0 times it sideways.";
    const InitialStressRegistry<2>::Entry<GeostaticStress<2>>
      geostatic_2d("geostatic", documentation);
    const InitialStressRegistry<3>::Entry<GeostaticStress<3>>
      geostatic_3d("geostatic", documentation);
  } // namespace
} // namespace mpm_granular::Points
