#ifndef mpm_granular_drive_drive_parameters_h
#define mpm_granular_drive_drive_parameters_h

#include <mpm_granular/materials/material.h>
#include <mpm_granular/parameters/named_groups.h>
#include <mpm_granular/parameters/parameter_group.h>

#include <string>
#include <vector>

namespace mpm_granular::Drive
{
  /// The settings of a test of one material point: materials as in any run, and
  /// what is done to the point.
  struct DriveParameters : Parameters::ParameterGroup
  {
    DriveParameters();

    Parameters::NamedGroups<Materials::Material<3>> materials;

    std::string         material; ///< empty: the first one
    std::string         test           = "triaxial compression";
    std::vector<double> initial_stress = {-1e5, -1e5, -1e5}; ///< [Pa]
    double              strain_rate    = 0.01;               ///< [1/s]
    std::vector<double> strains        = {0.1}; ///< where it turns back [-]
    unsigned int        n_steps        = 1000;
    std::string         directory      = "output-drive";

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    /// The material that is tested.
    const Materials::Material<3> &
    tested_material() const;
  };
} // namespace mpm_granular::Drive

#endif
