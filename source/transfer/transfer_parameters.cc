#include <deal.II/base/patterns.h>

#include <mpm_granular/parameters/pattern_text.h>
#include <mpm_granular/transfer/transfer_parameters.h>

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
      "How often the pressures of points in contact are replaced by smooth "
      "ones, which removes pressure noise (granular laws only). 0: never. "
      "'automatic': with c/h, wave speed over size of the filled cells, 0.8 "
      "c/h with 'Averaging = cells' (0.5 c/h on hypercubes), 0.2 c/h with "
      "'nodes', 0.3 c/h with 'moving least squares', 0 with 'none'. Units: 1/s.",
      Parameters::AutomaticNumber());
  }

  StressOrder
  TransferParameters::stress_order() const
  {
    return order == "USF" ? StressOrder::update_stress_first :
           order == "USL" ? StressOrder::update_stress_last :
                            StressOrder::modified_update_stress_last;
  }

  double
  TransferParameters::filter_rate(const double automatic) const
  {
    return Parameters::AutomaticNumber::value_of(pressure_filter_rate,
                                                 automatic);
  }
} // namespace mpm_granular::Transfer
