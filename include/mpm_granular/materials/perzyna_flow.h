#ifndef mpm_granular_materials_perzyna_flow_h
#define mpm_granular_materials_perzyna_flow_h

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace mpm_granular::Materials
{
  /// Constants of Perzyna's flow @cite perzyna1966, whose rate is gamma x^N with
  /// the overstress x over the strength (T6).
  struct PerzynaConstants
  {
    double fluidity = 50.; ///< gamma > 0 [1/s]
    double exponent = 1.;  ///< N > 0 [-]

    /// Declares and binds 'Fluidity' and 'Perzyna exponent'.
    void
    add_parameters(dealii::ParameterHandler &prm);
  };



  /// Perzyna's rule over a time step: the flow multiplier is amount x^exponent.
  struct PerzynaStep
  {
    double amount;   ///< gamma dt [-]; infinite: rate-independent
    double exponent; ///< N [-]
  };



  /// Perzyna's flow or, as its limit of infinite fluidity, none of its
  /// overstress.
  class PerzynaFlow
  {
  public:
    /// Declares and binds 'Flow' and what goes with it.
    void
    add_parameters(dealii::ParameterHandler &prm);

    /// @param time_step [s].
    PerzynaStep
    over(const double time_step) const;

  private:
    std::string      kind = "viscoplastic";
    PerzynaConstants constants;
  };



  /**
   * A stress Q and a strength Y that depend linearly on the flow multiplier l
   * of a step, Q = stress - stress_drop l and Y = strength + hardening l. They
   * are the trial values for l = 0.
   */
  struct LinearReturn
  {
    double stress;      ///< [Pa]
    double strength;    ///< [Pa]
    double stress_drop; ///< greater than zero [Pa]
    double hardening;   ///< more than -stress_drop [Pa]
  };

  /**
   * The multiplier l > 0 with Q = Y (1 + x), l = gamma dt x^N (T53a), for a
   * trial beyond the strength: in closed form if rate-independent or N = 1,
   * else by bracketing.
   *
   * @return not a number if there is none with Y >= 0 (then the stress returns
   *   to a corner), or if an argument is not one.
   */
  double
  flow_multiplier(const LinearReturn &path, const PerzynaStep &step);
} // namespace mpm_granular::Materials

#endif
