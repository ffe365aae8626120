#include <mpm_granular/momentum/body_force.h>

namespace mpm_granular::Momentum
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    const std::string no_force = dim == 2 ? "0; 0" : "0; 0; 0";
  }

  template <int dim>
  BodyForce<dim>::BodyForce()
    : force(no_force<dim>)
  {
    gravity[dim - 1] = -9.81;
  }

  template <int dim>
  void
  BodyForce<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Gravity",
                      gravity,
                      "Force per mass, the same everywhere. Units: m/s^2.");
    prm.add_parameter("Time factor",
                      factor,
                      "Factor on gravity, an expression of t. Units: -.");
    prm.add_parameter(
      "Force",
      force,
      "A further force per mass: components as expressions of "
      "x, y, z and t, separated by semicolons, evaluated at the "
      "nodes of the mesh. Its work is counted as boundary "
      "work. Units: m/s^2.");
  }

  template <int dim>
  void
  BodyForce<dim>::check() const
  {
    factor_expression.emplace(factor, 1, "Body force/Time factor");
    if (force != no_force<dim>)
      force_expression.emplace(force, dim, "Body force/Force");
  }

  template <int dim>
  Tensor<1, dim>
  BodyForce<dim>::gravity_at(const double time) const
  {
    return factor_expression->value(Point<dim>(), time) * gravity;
  }

  template <int dim>
  void
  BodyForce<dim>::add_loads(Grid::NodalFields<dim>          &fields,
                            const Mesh::BackgroundMesh<dim> &mesh,
                            const double                     time) const
  {
    if (!force_expression)
      return;
    for (unsigned int slot = 0; slot < fields.n_active_nodes(); ++slot)
      {
        auto            &node  = fields.sums[slot];
        const Point<dim> place = mesh.node_position(fields.active_nodes[slot]);
        for (unsigned int d = 0; d < dim; ++d)
          node.load[d] += node.mass * force_expression->value(place, time, d);
      }
  }

  template class BodyForce<2>;
  template class BodyForce<3>;
} // namespace mpm_granular::Momentum
