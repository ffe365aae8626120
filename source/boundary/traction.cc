#include <mpm_granular/boundary/traction.h>

namespace mpm_granular::Boundary
{
  using namespace dealii;

  template <int dim>
  void
  Traction<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Traction",
      text,
      "Components of the force per area on the material, "
      "expressions of x, y, z and t separated by semicolons. It "
      "acts on boundary faces whose cells hold points. Units: "
      "Pa.");
  }

  template <int dim>
  void
  Traction<dim>::check() const
  {
    expression.emplace(text, dim, "Traction");
  }

  template <int dim>
  Tensor<1, dim>
  Traction<dim>::traction(const Point<dim> &place, const double time) const
  {
    Tensor<1, dim> value;
    for (unsigned int d = 0; d < dim; ++d)
      value[d] = expression->value(place, time, d);
    return value;
  }

  template class Traction<2>;
  template class Traction<3>;

  namespace
  {
    const std::string documentation = "a given force per area.";
    const BoundaryConditionRegistry<2>::Entry<Traction<2>>
      traction_2d("traction", documentation);
    const BoundaryConditionRegistry<3>::Entry<Traction<3>>
      traction_3d("traction", documentation);
  } // namespace
} // namespace mpm_granular::Boundary
