#include <mpm_granular/transfer/fmpm.h>
#include <mpm_granular/transfer/mass_series.h>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  void
  Fmpm<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Order",
                      order,
                      "k of FMPM(k); 1 is PIC. Each order more costs a product "
                      "with the mass matrix. Units: -.",
                      Patterns::Integer(1, 100));
  }

  template <int dim>
  double
  Fmpm<dim>::pic_factor(const double) const
  {
    return 1.;
  }

  template <int dim>
  void
  Fmpm<dim>::find_motion(const NodalVelocities<dim> &velocities,
                         const double,
                         Grid::NodalFields<dim> &fields)
  {
    auto &sum = this->change;
    sum       = velocities.new_velocity;

    NodalVectors<dim> lost = sum;
    for (unsigned int power = 1; power < order; ++power)
      {
        keep_what_mapping_loses(fields, lost);
        velocities.constraints.project(lost);
        for (unsigned int i = 0; i < lost.size(); ++i)
          sum[i] += lost[i];
      }
    for (unsigned int i = 0; i < sum.size(); ++i)
      fields.motion[i].velocity = sum[i];
    this->set_change(fields);
  }

  template class Fmpm<2>;
  template class Fmpm<3>;

  namespace
  {
    const std::string documentation =
      "PIC with an approximate inverse of the consistent mass matrix, of a "
      "chosen order.";
    const VelocityUpdateRegistry<2>::Entry<Fmpm<2>> plane("FMPM",
                                                          documentation);
    const VelocityUpdateRegistry<3>::Entry<Fmpm<3>> space("FMPM",
                                                          documentation);
  } // namespace
} // namespace mpm_granular::Transfer
