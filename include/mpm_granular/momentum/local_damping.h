#ifndef mpm_granular_momentum_local_damping_h
#define mpm_granular_momentum_local_damping_h

#include <mpm_granular/momentum/damping.h>

namespace mpm_granular::Momentum
{
  /// Against the motion, in proportion to the force out of balance of each node
  /// and component (T31) [cundall1987]: no time scale, no damping of steady
  /// motion, and nothing to be chosen for a mesh or material.
  template <int dim>
  class LocalDamping : public Damping<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

  private:
    void
    add(const double             time_step,
        const NodalVectors<dim> &momentum,
        const NodalVectors<dim> &impulse,
        NodalVectors<dim>       &result) const override;

    double coefficient = 0.7;
  };
} // namespace mpm_granular::Momentum

#endif
