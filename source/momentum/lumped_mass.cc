#include <mpm_granular/momentum/lumped_mass.h>

namespace mpm_granular::Momentum
{
  using namespace dealii;

  template <int dim>
  void
  LumpedMass<dim>::add_parameters(ParameterHandler &)
  {}

  template <int dim>
  void
  LumpedMass<dim>::assemble(Grid::NodalFields<dim> &new_fields)
  {
    fields = &new_fields;
  }

  template <int dim>
  void
  LumpedMass<dim>::solve(const NodalVectors<dim>              &momentum,
                         const Grid::VelocityConstraints<dim> *constraints,
                         NodalVectors<dim>                    &velocity)
  {
    velocity.resize(momentum.size());
    for (unsigned int i = 0; i < momentum.size(); ++i)
      velocity[i] = momentum[i] / fields->sums[i].mass;
    if (constraints != nullptr)
      constraints->apply(velocity);
  }

  template <int dim>
  void
  LumpedMass<dim>::multiply(const NodalVectors<dim> &velocity,
                            NodalVectors<dim>       &momentum) const
  {
    momentum.resize(velocity.size());
    for (unsigned int i = 0; i < velocity.size(); ++i)
      momentum[i] = fields->sums[i].mass * velocity[i];
  }

  template class LumpedMass<2>;
  template class LumpedMass<3>;

  namespace
  {
    const std::string documentation = "the diagonal matrix of nodal masses.";
    const MassMatrixRegistry<2>::Entry<LumpedMass<2>> lumped_2d("lumped",
                                                                documentation);
    const MassMatrixRegistry<3>::Entry<LumpedMass<3>> lumped_3d("lumped",
                                                                documentation);
  } // namespace
} // namespace mpm_granular::Momentum
