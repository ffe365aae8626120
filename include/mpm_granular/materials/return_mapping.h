#ifndef mpm_granular_materials_return_mapping_h
#define mpm_granular_materials_return_mapping_h

#include <algorithm>

/*
 * The return of the equivalent stress q to the cone q = m p by Perzyna's rule
 * @cite perzyna1966, one step of backward Euler. The direction of the deviator
 * does not change, so that one number is unknown (T20).
 */
namespace mpm_granular::Materials
{
  /// The overstress x = (q - m p)/(m p) at the end of a step.
  struct Overstress
  {
    double       value;        ///< x >= 0 [-]
    unsigned int n_iterations; ///< of Newton's method
  };

  /**
   * Solves x + A x^N = x_tr (T20) by Newton's method, which converges
   * monotonically from the start of (T22), for N < 1 in y = x^N (T23).
   *
   * @param trial_overstress x_tr > 0 [-].
   * @param relaxation A = 3 G gamma dt / (m p) >= 0 [-].
   * @param exponent N > 0 [-].
   */
  Overstress
  overstress_after_step(const double trial_overstress,
                        const double relaxation,
                        const double exponent);

  /**
   * q / q_tr for any exponent.
   *
   * @param trial q_tr >= 0 [Pa].
   * @param yield m p >= 0; where it is below @p negligible, q = 0 [Pa].
   * @param flow 3 G gamma dt >= 0 [Pa].
   * @param exponent N > 0 [-].
   */
  double
  return_factor(const double trial,
                const double yield,
                const double flow,
                const double exponent,
                const double negligible);

  /**
   * q / q_tr for N = 1 in closed form (T21), q = m p (q_tr + 3 G gamma dt) /
   * (m p + 3 G gamma dt). Without branches: inside the cone that quotient is at
   * least 1, without pressure it is 0. Parameters as of return_factor().
   */
  inline double
  linear_return_factor(const double trial,
                       const double yield,
                       const double flow)
  {
    constexpr double no_zero_division = 1e-200; // [Pa^2]
    return std::min(yield * (trial + flow) /
                      ((yield + flow) * trial + no_zero_division),
                    1.);
  }
} // namespace mpm_granular::Materials

#endif
