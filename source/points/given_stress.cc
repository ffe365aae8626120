#include <mpm_granular/points/given_stress.h>

namespace mpm_granular::Points
{
  using namespace dealii;

  template <int dim>
  void
  NoStress<dim>::add_parameters(ParameterHandler &)
  {}

  template <int dim>
  Stress<dim>
  NoStress<dim>::stress(const Point<dim> &,
                        const double,
                        const Tensor<1, dim> &) const
  {
    return {};
  }

  template <int dim>
  void
  GivenStress<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Stress components",
      text,
      "Cauchy stress, tension positive: expressions of x, y and "
      "z separated by semicolons, in 2D for xx, yy, zz, xy, in "
      "3D for xx, yy, zz, xy, yz, zx. Units: Pa.");
  }

  template <int dim>
  void
  GivenStress<dim>::check() const
  {
    expression.emplace(text, n_stress<dim>, "Initial state/Stress components");
  }

  template <int dim>
  Stress<dim>
  GivenStress<dim>::stress(const Point<dim> &place,
                           const double,
                           const Tensor<1, dim> &) const
  {
    Stress<dim> result;
    for (unsigned int s = 0; s < n_stress<dim>; ++s)
      result[s] = expression->value(place, 0., s);
    return result;
  }

  template class NoStress<2>;
  template class NoStress<3>;
  template class GivenStress<2>;
  template class GivenStress<3>;

  namespace
  {
    const std::string none_documentation  = "no stress.";
    const std::string given_documentation = "given as functions of place.";
    template <int dim>
    using Registry = InitialStressRegistry<dim>;
    const Registry<2>::Entry<NoStress<2>> none_2d("none", none_documentation);
    const Registry<3>::Entry<NoStress<3>> none_3d("none", none_documentation);
    const Registry<2>::Entry<GivenStress<2>> given_2d("function",
                                                      given_documentation);
    const Registry<3>::Entry<GivenStress<3>> given_3d("function",
                                                      given_documentation);
  } // namespace
} // namespace mpm_granular::Points
