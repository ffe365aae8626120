#include <deal.II/base/patterns.h>

#include <boost/math/tools/toms748_solve.hpp>

#include <mpm_granular/materials/perzyna_flow.h>
#include <mpm_granular/parameters/documentation_handler.h>
#include <mpm_granular/parameters/pattern_text.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace mpm_granular::Materials
{
  using dealii::Patterns::Double;
  using dealii::Patterns::Selection;

  void
  PerzynaConstants::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Fluidity",
                      fluidity,
                      "Factor gamma of the viscoplastic flow, whose rate is "
                      "gamma x^N with the overstress x over the strength, in "
                      "material without cohesion x = (q - m p)/(m p). The "
                      "larger, the closer to rate-independent plasticity. "
                      "Units: 1/s.",
                      Parameters::positive_number());
    prm.add_parameter("Perzyna exponent",
                      exponent,
                      "Exponent N of the viscoplastic flow, at least 0.05. A "
                      "large N is not the rate-independent limit: the stress "
                      "then reaches up to twice the friction.",
                      Double(0.05, 100.));
  }



  void
  PerzynaFlow::add_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter(
      "Flow",
      kind,
      "'viscoplastic': the stress exceeds the strength the "
      "more, the faster the flow (Perzyna). 'rate-independent': "
      "it never does.",
      Selection("viscoplastic|rate-independent"));
    Parameters::only_with(prm, "Flow", "viscoplastic", kind, [&] {
      constants.add_parameters(prm);
    });
  }



  PerzynaStep
  PerzynaFlow::over(const double time_step) const
  {
    if (kind == "rate-independent")
      return {std::numeric_limits<double>::infinity(), 1.};
    return {constants.fluidity * time_step, constants.exponent};
  }



  namespace
  {
    constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

    /// N = 1: a l^2 + B l - c gamma dt = 0 (T53b).
    double
    linear_multiplier(const LinearReturn &path, const double amount)
    {
      const double a    = path.hardening;
      const double B    = amount * (path.stress_drop + a) + path.strength;
      const double c    = amount * (path.stress - path.strength);
      const double root = std::sqrt(B * B + 4. * a * c);
      return B > 0. ? 2. * c / (B + root) : (root - B) / (2. * a);
    }



    /// Any N: in x if N >= 1, else in l / (gamma dt), so that no slope is
    /// infinite.
    double
    bracketed_multiplier(const LinearReturn &path, const PerzynaStep &step)
    {
      const double power      = std::max(step.exponent, 1.);
      const double inverse    = std::max(1. / step.exponent, 1.);
      const auto   multiplier = [&](const double unknown) {
        return step.amount * std::pow(unknown, power);
      };
      const auto unknown_of = [&](const double lambda) {
        return std::pow(lambda / step.amount, 1. / power);
      };
      const auto excess = [&](const double unknown) {
        const double lambda = multiplier(unknown);
        return path.stress - path.stress_drop * lambda -
               (path.strength + path.hardening * lambda) *
                 (1. + std::pow(unknown, inverse));
      };
      const double lower =
        path.strength < 0. ? -path.strength / path.hardening : 0.;
      const double upper = path.stress / path.stress_drop;
      if (!(path.strength + path.hardening * upper >= 0.))
        return no_number;
      const double at_lower = excess(unknown_of(lower));
      const double at_upper = excess(unknown_of(upper));
      if (!(at_lower > 0.))
        return lower;
      if (!(at_upper < 0.)) // round-off: no strength at all
        return upper;
      const boost::math::tools::eps_tolerance<double> tolerance(46);
      std::uintmax_t                                  n_iterations = 200;
      const auto bracket = boost::math::tools::toms748_solve(excess,
                                                             unknown_of(lower),
                                                             unknown_of(upper),
                                                             at_lower,
                                                             at_upper,
                                                             tolerance,
                                                             n_iterations);
      return multiplier(.5 * (bracket.first + bracket.second));
    }
  } // namespace



  double
  flow_multiplier(const LinearReturn &path, const PerzynaStep &step)
  {
    if (std::isnan(path.stress) || std::isnan(path.strength) ||
        (path.strength < 0. && path.hardening <= 0.))
      return no_number;
    const double lambda =
      std::isinf(step.amount) ?
        (path.stress - path.strength) / (path.stress_drop + path.hardening) :
      step.exponent == 1. ? linear_multiplier(path, step.amount) :
                            bracketed_multiplier(path, step);
    const bool is_strong =
      path.hardening >= 0. || path.strength + path.hardening * lambda >= 0.;
    return is_strong ? lambda : no_number;
  }
} // namespace mpm_granular::Materials
