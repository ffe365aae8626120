#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/parameters/documentation_handler.h>
#include <mpm_granular/parameters/pattern_text.h>
#include <mpm_granular/time/step_control.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace mpm_granular::Time
{
  using namespace dealii;

  void
  StepParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Type",
                      type,
                      "'CFL': a part of the stability limit of the cells that "
                      "hold points; 'fixed': always the same step.",
                      Patterns::Selection("CFL|fixed"));
    Parameters::only_with(prm, "Type", "fixed", type, [&] {
      prm.add_parameter("Fixed step",
                        fixed_step,
                        "The time step; refused above the stability limit. "
                        "Units: s.",
                        Parameters::positive_number());
    });
    Parameters::only_with(prm, "Type", "CFL", type, [&] {
      prm.add_parameter("CFL",
                        cfl,
                        "Time step as a part of the stability limit of the "
                        "stiffest cell that holds points. Units: -.",
                        Patterns::Double(1e-6, 1.));
      prm.add_parameter("Growth limit",
                        growth,
                        "Largest ratio of a step to the one before. Units: -.",
                        Patterns::Double(1.));
      prm.add_parameter("Maximum displacement",
                        max_displacement,
                        "Largest way of a point in a step, as a part of the "
                        "smallest altitude of cells that hold points. Units: "
                        "-.",
                        Patterns::Double(1e-6, 1.));
      prm.add_parameter("Least step",
                        least_step,
                        "The run ends when the step falls below. Units: s.",
                        Patterns::Double(0.));
    });
  }

  StepControl::StepControl(const StepParameters &parameters)
    : parameters(parameters)
    , last_step(std::numeric_limits<double>::max())
  {}

  void
  StepControl::check_stability(const double critical_step) const
  {
    if (!parameters.is_fixed() || parameters.fixed_step <= critical_step)
      return;
    std::ostringstream message;
    message << "Time step/Fixed step = " << parameters.fixed_step
            << " s is above the stability limit of the mesh, " << critical_step
            << " s; choose at most that, or 'Type = CFL'.";
    throw InputError(message.str());
  }

  double
  StepControl::unconstrained_step(const StepLimits &limits) const
  {
    if (parameters.is_fixed())
      return parameters.fixed_step;
    double step = std::min(parameters.cfl * limits.critical_step,
                           parameters.growth * last_step);
    if (limits.largest_speed > 0.)
      step = std::min(step,
                      parameters.max_displacement * limits.least_altitude /
                        limits.largest_speed);
    return step;
  }

  double
  StepControl::next_step(const StepLimits &limits,
                         const double      time,
                         const double      next_event)
  {
    double step = unconstrained_step(limits);
    if (!(step > 0.) ||
        (!parameters.is_fixed() && step < parameters.least_step))
      {
        std::ostringstream message;
        message << "The time step collapsed to " << step
                << " s; the fastest point moves at " << limits.largest_speed
                << " m/s. Try a smaller CFL, more points per cell, or look at "
                   "the last output for points that fly off.";
        throw ComputationError(message.str());
      }
    last_step = step;

    // Equal steps to the event, so that the last one is not tiny. Round-off in
    // the time adds up over many steps and must not cost one more.
    constexpr double round_off = 1e-6;
    const double     rest      = next_event - time;
    const double     n_steps   = std::ceil(rest / step - round_off);
    return n_steps <= 1. ? rest : std::min(step, rest / n_steps);
  }

  void
  StepControl::serialize(Core::Archive &archive)
  {
    archive.replicated("time/last_free_step", last_step);
  }
} // namespace mpm_granular::Time
