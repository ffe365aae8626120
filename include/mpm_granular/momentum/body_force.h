#ifndef mpm_granular_momentum_body_force_h
#define mpm_granular_momentum_body_force_h

#include <deal.II/base/tensor.h>

#include <mpm_granular/core/expression.h>
#include <mpm_granular/grid/nodal_fields.h>
#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/parameters/parameter_group.h>

#include <optional>
#include <string>

namespace mpm_granular::Momentum
{
  /// Forces per mass (T10): gravity, the same everywhere, as a function of
  /// time; and another one that may depend on place, such as that of a rotating
  /// frame or of a manufactured solution.
  template <int dim>
  class BodyForce : public Parameters::ParameterGroup
  {
  public:
    BodyForce();

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    /// Gravity at @p time [m/s^2].
    dealii::Tensor<1, dim>
    gravity_at(const double time) const;

    /**
     * Adds the force that depends on place to NodeSums::load: nodal mass times
     * its value at the node, which is the force on points where it is
     * interpolated linearly in the cells. In the energy ledger loads count as
     * boundary work.
     *
     * @param fields nodes with their masses, summed over all ranks.
     * @param mesh the mesh of the fields.
     * @param time [s].
     */
    void
    add_loads(Grid::NodalFields<dim>          &fields,
              const Mesh::BackgroundMesh<dim> &mesh,
              const double                     time) const;

  private:
    dealii::Tensor<1, dim>                       gravity;
    std::string                                  factor = "1";
    std::string                                  force;
    mutable std::optional<Core::Expression<dim>> factor_expression;
    mutable std::optional<Core::Expression<dim>> force_expression;
  };
} // namespace mpm_granular::Momentum

#endif
