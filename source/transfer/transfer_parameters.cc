#include <deal.II/base/patterns.h>

#include <mpm_granular/transfer/transfer_parameters.h>

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
      "Pressure filter rate",
      pressure_filter_rate,
      "Rate at which the pressures of points in contact relax to a smooth "
      "field, which removes pressure noise (granular laws only). 0: never; "
      "0.8 times wave speed over cell size is a good value for flows "
      "with 'Averaging = cells', 0.2 to 0.3 times with others. "
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
  TransferParameters::filter_fraction(const double duration) const
  {
    return std::min(1., pressure_filter_rate * duration);
  }
} // namespace mpm_granular::Transfer
