#include <mpm_granular/materials/return_mapping.h>

#include <cmath>
#include <limits>

namespace mpm_granular::Materials
{
  namespace
  {
    /// base^exponent; an integer one, as 2 or 3, takes products only, a tenth
    /// of the time.
    double
    power(double base, const double exponent)
    {
      constexpr double largest_integer = 32.;
      if (exponent > largest_integer || exponent != std::floor(exponent))
        return std::pow(base, exponent);
      double result = 1.;
      for (unsigned int n = exponent; n > 0; n /= 2, base *= base)
        if (n % 2 == 1)
          result *= base;
      return result;
    }



    /**
     * Solves a z + b z^M = c with M >= 1 and a, b >= 0, c > 0: increasing and
     * convex, so that Newton's method decreases to the root from a start where
     * the left side is at least c.
     */
    Overstress
    solve_convex(const double a, const double b, const double c, const double M)
    {
      // After a change as small as this, the quadratic convergence has reached
      // round-off.
      constexpr double       tolerance        = 1e-9;
      constexpr unsigned int max_n_iterations = 50;

      double z = std::min(c / a, std::pow(c / b, 1. / M));
      for (unsigned int k = 1; k <= max_n_iterations; ++k)
        {
          // z - (a z + b z^M - c) / (a + M b z^(M-1)), without differences.
          const double slope = b * power(z, M - 1.);
          const double next  = ((M - 1.) * slope * z + c) / (a + M * slope);
          const bool   done  = std::abs(next - z) <= tolerance * z;
          z                  = next;
          if (done)
            return {z, k};
        }
      return {std::numeric_limits<double>::quiet_NaN(), max_n_iterations};
    }
  } // namespace



  Overstress
  overstress_after_step(const double trial_overstress,
                        const double relaxation,
                        const double exponent)
  {
    if (exponent >= 1.)
      return solve_convex(1., relaxation, trial_overstress, exponent);
    Overstress result =
      solve_convex(relaxation, 1., trial_overstress, 1. / exponent);
    result.value = power(result.value, 1. / exponent);
    return result;
  }



  double
  return_factor(const double trial,
                const double yield,
                const double flow,
                const double exponent,
                const double negligible)
  {
    if (yield <= negligible)
      return 0.;
    if (trial <= yield)
      return 1.;
    const double overstress =
      overstress_after_step((trial - yield) / yield, flow / yield, exponent)
        .value;
    return yield * (1. + overstress) / trial;
  }
} // namespace mpm_granular::Materials
