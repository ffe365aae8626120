#include <deal.II/base/patterns.h>

#include <mpm_granular/momentum/local_damping.h>

#include <cmath>

namespace mpm_granular::Momentum
{
  using namespace dealii;

  template <int dim>
  void
  LocalDamping<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Damping coefficient",
                      coefficient,
                      "Damping force over the force out of balance. The "
                      "amplitude falls by sqrt((1 - a)/(1 + a)) in half a "
                      "period. Units: -.",
                      Patterns::Double(0., 0.99));
  }

  template <int dim>
  void
  LocalDamping<dim>::add(const double,
                         const NodalVectors<dim> &momentum,
                         const NodalVectors<dim> &impulse,
                         NodalVectors<dim>       &result) const
  {
    for (unsigned int i = 0; i < momentum.size(); ++i)
      for (unsigned int d = 0; d < dim; ++d)
        if (momentum[i][d] != 0.)
          result[i][d] -=
            std::copysign(coefficient * impulse[i][d], momentum[i][d]);
  }

  template class LocalDamping<2>;
  template class LocalDamping<3>;

  namespace
  {
    const std::string documentation =
      "a part of the force out of balance, against the motion of each node.";
    const DampingRegistry<2>::Entry<LocalDamping<2>> local_2d("local",
                                                              documentation);
    const DampingRegistry<3>::Entry<LocalDamping<3>> local_3d("local",
                                                              documentation);
  } // namespace
} // namespace mpm_granular::Momentum
