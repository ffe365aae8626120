#include <deal.II/base/patterns.h>

#include <mpm_granular/momentum/viscous_damping.h>

#include <cmath>

namespace mpm_granular::Momentum
{
  using namespace dealii;

  template <int dim>
  void
  ViscousDamping<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Damping rate",
                      rate,
                      "Damping force over mass and velocity; twice the lowest "
                      "angular frequency is critical. Units: 1/s.",
                      Patterns::Double(0.));
  }

  template <int dim>
  void
  ViscousDamping<dim>::add(const double             time_step,
                           const NodalVectors<dim> &momentum,
                           const NodalVectors<dim> &,
                           NodalVectors<dim> &result) const
  {
    // Exact for free motion, so that no step is too long.
    const double lost_part = -std::expm1(-rate * time_step);
    for (unsigned int i = 0; i < momentum.size(); ++i)
      result[i] -= lost_part * momentum[i];
  }

  template class ViscousDamping<2>;
  template class ViscousDamping<3>;

  namespace
  {
    const std::string documentation =
      "a force in proportion to mass and velocity of each node.";
    const DampingRegistry<2>::Entry<ViscousDamping<2>>
      viscous_2d("viscous", documentation);
    const DampingRegistry<3>::Entry<ViscousDamping<3>>
      viscous_3d("viscous", documentation);
  } // namespace
} // namespace mpm_granular::Momentum
