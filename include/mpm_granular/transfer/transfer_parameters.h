#ifndef mpm_granular_transfer_transfer_parameters_h
#define mpm_granular_transfer_transfer_parameters_h

#include <mpm_granular/parameters/parameter_group.h>

#include <string>

namespace mpm_granular::Transfer
{
  /// Which velocity strains the points, and when (T15).
  enum class StressOrder
  {
    update_stress_first, ///< USF: the mapped old velocity, before the forces
    update_stress_last,  ///< USL: the new velocity
    modified_update_stress_last ///< MUSL: the points' new momentum re-mapped
  };

  /// When points are strained, and how their pressures are filtered.
  struct TransferParameters : Parameters::ParameterGroup
  {
    void
    add_parameters(dealii::ParameterHandler &prm) override;

    StressOrder
    stress_order() const;

    /// Rate at which the pressures of points in contact go to a smooth one
    /// (T29) [1/s].
    /// @param automatic the rate that suits the body and the averages.
    double
    filter_rate(const double automatic) const;

  private:
    std::string order                = "MUSL";
    std::string pressure_filter_rate = "automatic"; ///< [1/s]
  };
} // namespace mpm_granular::Transfer

#endif
