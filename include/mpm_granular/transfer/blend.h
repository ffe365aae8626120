#ifndef mpm_granular_transfer_blend_h
#define mpm_granular_transfer_blend_h

#include <mpm_granular/transfer/xpic.h>

namespace mpm_granular::Transfer
{
  /// FLIP that replaces a part of the points' velocity at a rate: by that of
  /// PIC (T14), or of XPIC(k) (T66).
  template <int dim>
  class Blend : public Xpic<dim>
  {
  public:
    Blend();

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    double
    pic_factor(const double time_step) const override;

  private:
    double pic_rate = 3.; ///< [1/s]
  };
} // namespace mpm_granular::Transfer

#endif
