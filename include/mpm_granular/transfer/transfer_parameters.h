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

    /// The part of the way to the smooth pressure (T29) that points in contact
    /// go in a time.
    double
    filter_fraction(const double duration) const;

  private:
    std::string order                = "MUSL";
    double      pressure_filter_rate = 0.; ///< [1/s]
  };
} // namespace mpm_granular::Transfer

#endif
