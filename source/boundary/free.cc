#include <mpm_granular/boundary/free.h>

namespace mpm_granular::Boundary
{
  template <int dim>
  void
  Free<dim>::add_parameters(dealii::ParameterHandler &)
  {}

  template class Free<2>;
  template class Free<3>;

  namespace
  {
    const std::string documentation = "open; points may leave the mesh there.";
    const BoundaryConditionRegistry<2>::Entry<Free<2>> free_2d("free",
                                                               documentation);
    const BoundaryConditionRegistry<3>::Entry<Free<3>> free_3d("free",
                                                               documentation);
  } // namespace
} // namespace mpm_granular::Boundary
