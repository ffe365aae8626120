#ifndef mpm_granular_momentum_viscous_damping_h
#define mpm_granular_momentum_viscous_damping_h

#include <mpm_granular/momentum/damping.h>

namespace mpm_granular::Momentum
{
  /// In proportion to mass and velocity (T32): oscillations die out as
  /// exp(-c t/2), free motion as exp(-c t).
  template <int dim>
  class ViscousDamping : public Damping<dim>
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

    double rate = 1.; ///< c [1/s]
  };
} // namespace mpm_granular::Momentum

#endif
