#include <mpm_granular/transfer/mass_series.h>
#include <mpm_granular/transfer/xpic.h>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  Xpic<dim>::Xpic(const unsigned int default_order)
    : order(default_order)
  {}

  template <int dim>
  void
  Xpic<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Order",
                      order,
                      "k of XPIC(k), which takes the place of PIC, k = 1. Each "
                      "order more costs a product with the mass matrix. Units: "
                      "-.",
                      Patterns::Integer(1, 100));
  }

  template <int dim>
  double
  Xpic<dim>::pic_factor(const double) const
  {
    return 1.;
  }

  template <int dim>
  void
  Xpic<dim>::find_motion(const NodalVelocities<dim> &velocities,
                         const double                time_step,
                         Grid::NodalFields<dim>     &fields)
  {
    VelocityUpdate<dim>::find_motion(velocities, time_step, fields);
    if (order == 1)
      return;
    const double      c    = this->pic_factor(time_step);
    NodalVectors<dim> lost = velocities.old_velocity;
    for (unsigned int power = 1; power < order; ++power)
      {
        keep_what_mapping_loses(fields, lost);
        for (unsigned int i = 0; i < lost.size(); ++i)
          this->change[i] += c * lost[i];
      }
    this->set_change(fields);
  }

  template class Xpic<2>;
  template class Xpic<3>;

  namespace
  {
    const std::string documentation =
      "PIC that keeps what the grid represents of the points' velocity, to a "
      "chosen order.";
    const VelocityUpdateRegistry<2>::Entry<Xpic<2>> plane("XPIC",
                                                          documentation);
    const VelocityUpdateRegistry<3>::Entry<Xpic<3>> space("XPIC",
                                                          documentation);
  } // namespace
} // namespace mpm_granular::Transfer
