#include <mpm_granular/boundary/coulomb_wall.h>

namespace mpm_granular::Boundary
{
  using namespace dealii;

  template <int dim>
  void
  CoulombWall<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Friction coefficient",
                      friction,
                      "Largest tangential over normal force. Units: -.",
                      Patterns::Double(0.));
  }

  template <int dim>
  std::vector<Tensor<1, dim>>
  CoulombWall<dim>::prescribed_directions(const Tensor<1, dim> &normal) const
  {
    return {normal};
  }

  template class CoulombWall<2>;
  template class CoulombWall<3>;

  namespace
  {
    const std::string documentation =
      "a wall that pushes but does not hold, with friction; for the lumped "
      "mass matrix.";
    const BoundaryConditionRegistry<2>::Entry<CoulombWall<2>>
      wall_2d("Coulomb friction", documentation);
    const BoundaryConditionRegistry<3>::Entry<CoulombWall<3>>
      wall_3d("Coulomb friction", documentation);
  } // namespace
} // namespace mpm_granular::Boundary
