#ifndef mpm_granular_momentum_lumped_mass_h
#define mpm_granular_momentum_lumped_mass_h

#include <mpm_granular/momentum/mass_matrix.h>

namespace mpm_granular::Momentum
{
  /// The diagonal matrix of the nodal masses (row sums).
  template <int dim>
  class LumpedMass : public MassMatrix<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    bool
    handles_contact() const override
    {
      return true;
    }

    void
    assemble(Grid::NodalFields<dim> &fields) override;

    void
    solve(const NodalVectors<dim>              &momentum,
          const Grid::VelocityConstraints<dim> *constraints,
          NodalVectors<dim>                    &velocity) override;

    void
    multiply(const NodalVectors<dim> &velocity,
             NodalVectors<dim>       &momentum) const override;

    double
    time_step_factor() const override
    {
      return 1.;
    }

  private:
    const Grid::NodalFields<dim> *fields = nullptr;
  };
} // namespace mpm_granular::Momentum

#endif
