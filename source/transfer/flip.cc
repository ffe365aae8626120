#include <mpm_granular/transfer/flip.h>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  void
  Flip<dim>::add_parameters(ParameterHandler &)
  {}

  template <int dim>
  double
  Flip<dim>::pic_factor(const double) const
  {
    return 0.;
  }

  template <int dim>
  void
  Pic<dim>::add_parameters(ParameterHandler &)
  {}

  template <int dim>
  double
  Pic<dim>::pic_factor(const double) const
  {
    return 1.;
  }

  template class Flip<2>;
  template class Flip<3>;
  template class Pic<2>;
  template class Pic<3>;

  namespace
  {
    const std::string flip = "adds the change of the grid's velocity.";
    const std::string pic  = "takes over the grid's velocity (the paper's eq. "
                             "16).";
    const VelocityUpdateRegistry<2>::Entry<Flip<2>> flip_2d("FLIP", flip);
    const VelocityUpdateRegistry<3>::Entry<Flip<3>> flip_3d("FLIP", flip);
    const VelocityUpdateRegistry<2>::Entry<Pic<2>>  pic_2d("PIC", pic);
    const VelocityUpdateRegistry<3>::Entry<Pic<3>>  pic_3d("PIC", pic);
  } // namespace
} // namespace mpm_granular::Transfer
