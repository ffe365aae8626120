#ifndef mpm_granular_time_step_control_h
#define mpm_granular_time_step_control_h

#include <mpm_granular/core/archive.h>
#include <mpm_granular/parameters/parameter_group.h>

#include <string>

namespace mpm_granular::Time
{
  /// Settings of the time step.
  struct StepParameters : Parameters::ParameterGroup
  {
    bool
    is_fixed() const
    {
      return type == "fixed";
    }

    double cfl              = 0.5;  ///< part of the stability limit
    double fixed_step       = 1e-4; ///< [s]
    double growth           = 1.1;  ///< largest ratio of successive steps
    double max_displacement = 0.2;  ///< of a point per step, in cell altitudes
    double least_step       = 1e-9; ///< [s]

    void
    add_parameters(dealii::ParameterHandler &prm) override;

  private:
    std::string type = "CFL";
  };

  /// What limits a step now.
  struct StepLimits
  {
    double critical_step;  ///< stability limit of the active cells [s]
    double least_altitude; ///< of the active cells [m]
    double largest_speed;  ///< of the points [m/s]
  };

  /**
   * Chooses the time steps (T25): the fixed one, or a part of the limits, which
   * grows slowly and lands exactly on given times.
   */
  class StepControl
  {
  public:
    explicit StepControl(const StepParameters &parameters);

    /**
     * Refuses a fixed step above the stability limit.
     *
     * @throws InputError with both numbers.
     */
    void
    check_stability(const double critical_step) const;

    /**
     * The next step from @p time, which does not pass @p next_event.
     *
     * @throws ComputationError if the step collapses.
     */
    double
    next_step(const StepLimits &limits,
              const double      time,
              const double      next_event);

    /// What the growth of steps depends on, for checkpoints.
    void
    serialize(Core::Archive &archive);

  private:
    double
    unconstrained_step(const StepLimits &limits) const;

    const StepParameters parameters;
    double               last_step; ///< not shortened for an event [s]
  };
} // namespace mpm_granular::Time

#endif
