#include <mpm_granular/boundary/clamp.h>


namespace mpm_granular::Boundary
{
  using namespace dealii;

  template <int dim>
  void
  Clamp<dim>::add_parameters(ParameterHandler &)
  {}

  template <int dim>
  std::vector<Tensor<1, dim>>
  Clamp<dim>::prescribed_directions(const Tensor<1, dim> & /*normal*/) const
  {
    std::vector<Tensor<1, dim>> axes;
    for (unsigned int d = 0; d < dim; ++d)
      axes.push_back(Point<dim>::unit_vector(d));
    return axes;
  }

  template class Clamp<2>;
  template class Clamp<3>;

  namespace
  {
    const std::string documentation = "no velocity (a rough wall).";
    const BoundaryConditionRegistry<2>::Entry<Clamp<2>> clamp_2d("clamp",
                                                                 documentation);
    const BoundaryConditionRegistry<3>::Entry<Clamp<3>> clamp_3d("clamp",
                                                                 documentation);
  } // namespace
} // namespace mpm_granular::Boundary
