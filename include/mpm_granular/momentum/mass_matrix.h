#ifndef mpm_granular_momentum_mass_matrix_h
#define mpm_granular_momentum_mass_matrix_h

#include <mpm_granular/core/registry.h>
#include <mpm_granular/grid/nodal_fields.h>
#include <mpm_granular/grid/velocity_constraints.h>
#include <mpm_granular/parameters/parameter_group.h>

#include <vector>

namespace mpm_granular::Momentum
{
  /// One vector per active node, by slot.
  template <int dim>
  using NodalVectors = std::vector<dealii::Tensor<1, dim>>;

  /// The mass matrix between velocities and momenta of the active nodes (T11).
  template <int dim>
  class MassMatrix : public Parameters::ParameterGroup
  {
  public:
    /// Prepares for a mesh, or for its new cells.
    virtual void
    reinit(const Mesh::BackgroundMesh<dim> & /*mesh*/)
    {}

    /// Whether constraints may be walls that push only.
    virtual bool
    handles_contact() const
    {
      return false;
    }

    /// Takes over the masses of this step. Like solve() and multiply(),
    /// collective.
    virtual void
    assemble(Grid::NodalFields<dim> &fields) = 0;

    /**
     * Solves M v = @p momentum.
     *
     * @param constraints prescribed components of v, or nullptr; the equations
     *   of these components are then left out (their residual is the reaction).
     */
    virtual void
    solve(const NodalVectors<dim>              &momentum,
          const Grid::VelocityConstraints<dim> *constraints,
          NodalVectors<dim>                    &velocity) = 0;

    /// momentum = M v.
    virtual void
    multiply(const NodalVectors<dim> &velocity,
             NodalVectors<dim>       &momentum) const = 0;

    /// Ratio of the stable time step to that of the lumped matrix (T24).
    virtual double
    time_step_factor() const = 0;
  };

  template <int dim>
  using MassMatrixRegistry = Core::Registry<MassMatrix<dim>>;
} // namespace mpm_granular::Momentum

#endif
