#ifndef mpm_granular_transfer_xpic_h
#define mpm_granular_transfer_xpic_h

#include <mpm_granular/transfer/velocity_update.h>

namespace mpm_granular::Transfer
{
  /**
   * XPIC(k): points take over what the grid represents of their velocity, to
   * the order k, and add the change of the grid's velocity (T66). k = 1 is PIC;
   * with growing k less and less is lost that the grid could represent.
   *
   * Hammerquist and Nairn (2017).
   */
  template <int dim>
  class Xpic : public VelocityUpdate<dim>
  {
  public:
    explicit Xpic(const unsigned int default_order = 2);

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    bool
    needs_lumped_mass() const override
    {
      return order > 1;
    }

    double
    pic_factor(const double time_step) const override;

    void
    find_motion(const NodalVelocities<dim> &velocities,
                const double                time_step,
                Grid::NodalFields<dim>     &fields) override;

  private:
    unsigned int order;
  };
} // namespace mpm_granular::Transfer

#endif
