#include <mpm_granular/transfer/blend.h>

#include <algorithm>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  Blend<dim>::Blend()
    : Xpic<dim>(1)
  {}

  template <int dim>
  void
  Blend<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("PIC rate",
                      pic_rate,
                      "Part of the points' velocity that is replaced by the "
                      "grid's, per time. As a rate it does not depend on the "
                      "time step. Units: 1/s.",
                      Patterns::Double(0.));
    Xpic<dim>::add_parameters(prm);
  }

  template <int dim>
  double
  Blend<dim>::pic_factor(const double time_step) const
  {
    return std::min(1., pic_rate * time_step);
  }

  template class Blend<2>;
  template class Blend<3>;

  namespace
  {
    const std::string documentation =
      "FLIP that replaces a small part at a rate.";
    const VelocityUpdateRegistry<2>::Entry<Blend<2>> plane("blend",
                                                           documentation);
    const VelocityUpdateRegistry<3>::Entry<Blend<3>> space("blend",
                                                           documentation);
  } // namespace
} // namespace mpm_granular::Transfer
