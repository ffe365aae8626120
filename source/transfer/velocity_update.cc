#include <mpm_granular/parameters/documentation_handler.h>
#include <mpm_granular/transfer/velocity_update.h>

#include <algorithm>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  void
  TransferParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Stress order",
      order,
      "When stresses are updated, and with the gradient of which "
      "velocity: before the forces, with the mapped velocity "
      "(USF); after the momentum balance, with the new velocity "
      "(USL); the same with the velocity re-mapped from the "
      "points (MUSL).",
      Patterns::Selection("MUSL|USL|USF"));
    prm.add_parameter(
      "Velocity update",
      velocity_update,
      "How points take their velocity from the grid: 'FLIP' adds "
      "its change; 'PIC' replaces it (the paper's eq. 16); "
      "'blend' is FLIP that replaces a small part at a rate.",
      Patterns::Selection("blend|FLIP|PIC"));
    Parameters::only_with(
      prm, "Velocity update", "blend", velocity_update, [&] {
        prm.add_parameter(
          "PIC rate",
          pic_rate,
          "Part of the points' velocity that is replaced by the "
          "grid's, per time. As a rate it does not depend on the "
          "time step. Units: 1/s.",
          Patterns::Double(0.));
      });
    prm.add_parameter(
      "Pressure filter rate",
      pressure_filter_rate,
      "Rate at which the pressures of points in contact relax to a smooth "
      "field, which removes pressure noise (granular laws only). 0: never; "
      "0.2 times wave speed over cell size is a good value for flows. "
      "Units: 1/s.",
      Patterns::Double(0.));
  }

  StressOrder
  TransferParameters::stress_order() const
  {
    return order == "USF" ? StressOrder::update_stress_first :
           order == "USL" ? StressOrder::update_stress_last :
                            StressOrder::modified_update_stress_last;
  }

  double
  TransferParameters::pic_factor(const double time_step) const
  {
    return velocity_update == "FLIP" ? 0. :
           velocity_update == "PIC"  ? 1. :
                                       std::min(1., pic_rate * time_step);
  }

  double
  TransferParameters::filter_fraction(const double duration) const
  {
    return std::min(1., pressure_filter_rate * duration);
  }
} // namespace mpm_granular::Transfer
