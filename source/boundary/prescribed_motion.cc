#include <mpm_granular/boundary/prescribed_motion.h>

namespace mpm_granular::Boundary
{
  using namespace dealii;

  namespace
  {
    const std::string axes = "xyz";
  }

  template <int dim>
  PrescribedMotion<dim>::PrescribedMotion(const std::string &quantity,
                                          const std::string &unit)
    : quantity(quantity)
    , unit(unit)
  {
    for (unsigned int d = 0; d < dim; ++d)
      components.push_back(axes.substr(d, 1));
  }

  template <int dim>
  void
  PrescribedMotion<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      quantity,
      text,
      "All components, expressions of x, y, z and t separated by "
      "semicolons. Units: " +
        unit + ".");
    prm.add_parameter(
      "Components",
      components,
      "The components that are prescribed; others are free.",
      Patterns::List(Patterns::Selection(dim == 2 ? "x|y" : "x|y|z"), 1, dim));
  }

  template <int dim>
  void
  PrescribedMotion<dim>::check() const
  {
    expression.emplace(text, dim, quantity);
  }

  template <int dim>
  std::vector<Tensor<1, dim>>
  PrescribedMotion<dim>::prescribed_directions(const Tensor<1, dim> &) const
  {
    std::vector<Tensor<1, dim>> directions;
    for (const auto &component : components)
      directions.push_back(Point<dim>::unit_vector(axes.find(component)));
    return directions;
  }

  template <int dim>
  Tensor<1, dim>
  PrescribedMotion<dim>::value(const Point<dim> &place, const double time) const
  {
    Tensor<1, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = expression->value(place, time, d);
    return result;
  }

  template <int dim>
  PrescribedVelocity<dim>::PrescribedVelocity()
    : PrescribedMotion<dim>("Velocity", "m/s")
  {}

  template <int dim>
  Tensor<1, dim>
  PrescribedVelocity<dim>::velocity(const Point<dim> &place,
                                    const double      time,
                                    const double      time_step) const
  {
    return this->value(place, time + time_step);
  }

  template <int dim>
  PrescribedDisplacement<dim>::PrescribedDisplacement()
    : PrescribedMotion<dim>("Displacement", "m")
  {}

  template <int dim>
  Tensor<1, dim>
  PrescribedDisplacement<dim>::velocity(const Point<dim> &place,
                                        const double      time,
                                        const double      time_step) const
  {
    return (this->value(place, time + time_step) - this->value(place, time)) /
           time_step;
  }

  template class PrescribedVelocity<2>;
  template class PrescribedVelocity<3>;
  template class PrescribedDisplacement<2>;
  template class PrescribedDisplacement<3>;

  namespace
  {
    const std::string velocity_documentation =
      "velocity components given as functions of place and time.";
    const std::string displacement_documentation =
      "displacement components given as functions of place and time.";
    template <int dim>
    using Registry = BoundaryConditionRegistry<dim>;
    const Registry<2>::Entry<PrescribedVelocity<2>>
      velocity_2d("prescribed velocity", velocity_documentation);
    const Registry<3>::Entry<PrescribedVelocity<3>>
      velocity_3d("prescribed velocity", velocity_documentation);
    const Registry<2>::Entry<PrescribedDisplacement<2>>
      displacement_2d("prescribed displacement", displacement_documentation);
    const Registry<3>::Entry<PrescribedDisplacement<3>>
      displacement_3d("prescribed displacement", displacement_documentation);
  } // namespace
} // namespace mpm_granular::Boundary
