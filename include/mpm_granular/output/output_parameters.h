#ifndef mpm_granular_output_output_parameters_h
#define mpm_granular_output_output_parameters_h

#include <mpm_granular/parameters/parameter_group.h>

#include <string>
#include <vector>

namespace mpm_granular::Output
{
  /// What is written, where, and how often. Entries of the current subsection.
  struct OutputParameters : public Parameters::ParameterGroup
  {
    std::string              directory            = "output";
    double                   interval             = 0.1;  ///< [s]
    double                   observables_interval = 0.01; ///< [s]
    double                   progress_interval    = 10.;  ///< wall time [s]
    std::vector<std::string> point_fields         = {"all"};
    unsigned int             every_nth_point      = 1;
    bool                     write_grid           = false;
    std::string              format               = "VTU";
    unsigned int             ranks_per_file       = 1; ///< PVTU
    std::string              compression          = "none";

    void
    add_parameters(dealii::ParameterHandler &prm) override;

    void
    check() const override;

    /// The level of compression, from 0, not at all, to 9.
    unsigned int
    compression_level() const;
  };
} // namespace mpm_granular::Output

#endif
