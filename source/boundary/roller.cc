#include <mpm_granular/boundary/roller.h>

namespace mpm_granular::Boundary
{
  using namespace dealii;

  template <int dim>
  void
  Roller<dim>::add_parameters(ParameterHandler &)
  {}

  template <int dim>
  std::vector<Tensor<1, dim>>
  Roller<dim>::prescribed_directions(const Tensor<1, dim> &normal) const
  {
    return {normal};
  }

  template class Roller<2>;
  template class Roller<3>;

  namespace
  {
    const std::string documentation =
      "no velocity along the normal, no friction (a symmetry plane).";
    const BoundaryConditionRegistry<2>::Entry<Roller<2>>
      roller_2d("roller", documentation);
    const BoundaryConditionRegistry<3>::Entry<Roller<3>>
      roller_3d("roller", documentation);
  } // namespace
} // namespace mpm_granular::Boundary
