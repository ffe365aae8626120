#ifndef mpm_granular_transfer_flip_h
#define mpm_granular_transfer_flip_h

#include <mpm_granular/transfer/velocity_update.h>

namespace mpm_granular::Transfer
{
  /// Points add the change of the grid's velocity (T14 with c = 0).
  template <int dim>
  class Flip : public VelocityUpdate<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    double
    pic_factor(const double time_step) const override;
  };

  /// Points take over the grid's velocity (T14 with c = 1): the paper's (16).
  template <int dim>
  class Pic : public VelocityUpdate<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    double
    pic_factor(const double time_step) const override;
  };
} // namespace mpm_granular::Transfer

#endif
