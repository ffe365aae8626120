#ifndef mpm_granular_transfer_fmpm_h
#define mpm_granular_transfer_fmpm_h

#include <mpm_granular/transfer/velocity_update.h>

namespace mpm_granular::Transfer
{
  /**
   * FMPM(k): points take over, and move with, the velocity that an inverse of
   * the consistent mass matrix, approximated to the order k, gives (T67). k = 1
   * is PIC.
   *
   * Nairn and Hammerquist (2021).
   */
  template <int dim>
  class Fmpm : public VelocityUpdate<dim>
  {
  public:
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    bool
    needs_lumped_mass() const override
    {
      return order > 1;
    }

    /// The series would move nodes into walls that are open.
    bool
    handles_contact() const override
    {
      return order == 1;
    }

    double
    pic_factor(const double time_step) const override;

    void
    find_motion(const NodalVelocities<dim> &velocities,
                const double                time_step,
                Grid::NodalFields<dim>     &fields) override;

  private:
    unsigned int order = 2;
  };
} // namespace mpm_granular::Transfer

#endif
