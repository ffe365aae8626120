#ifndef mpm_granular_output_preflight_h
#define mpm_granular_output_preflight_h

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace mpm_granular::Output
{
  /**
   * What a run will be, known before its first step. Whoever knows a number
   * fills it in; numbers that nobody filled in are NaN and not printed.
   */
  struct Preflight
  {
    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    /// A material as the report shows it.
    struct Material
    {
      std::string   name;
      std::string   law;
      double        density;    ///< [kg/m^3]
      double        wave_speed; ///< of pressure waves [m/s]
      std::uint64_t n_points;
    };

    unsigned int  dimension      = 0;
    std::uint64_t n_cells        = 0;
    std::uint64_t n_nodes        = 0;
    double        mean_cell_size = unknown; ///< [m]
    double        min_altitude   = unknown; ///< [m]

    std::uint64_t n_points            = 0;
    std::uint64_t n_filled_cells      = 0;
    double        min_points_per_cell = unknown; ///< over filled cells
    double        max_points_per_cell = unknown; ///< over filled cells
    double        mass                = unknown; ///< [kg], in 2D [kg/m]
    double        volume              = unknown; ///< [m^3], in 2D [m^2]

    std::vector<Material> materials;

    std::string averaging;                 ///< name of the scheme
    double      pressure_filter_rate = 0.; ///< [1/s]
    double      position_shift_rate  = 0.; ///< [1/s]

    double       end_time        = unknown; ///< [s]
    double       stable_dt       = unknown; ///< stability limit [s]
    double       chosen_dt       = unknown; ///< [s]
    double       gravity         = unknown; ///< [m/s^2]
    double       n_files         = unknown; ///< files of points
    double       bytes_per_file  = unknown;
    double       bytes_in_memory = unknown; ///< on all ranks
    unsigned int n_ranks         = 1;

    /// Million point-steps a second, to estimate the time: measured, or the
    /// default of Release builds on one core of an ordinary machine.
    double throughput = 20.;

    std::vector<std::string> warnings;

    double
    mean_points_per_cell() const;
    double
    n_steps() const;
    double
    wall_time() const; ///< estimate [s]

    /**
     * Adds the warnings that follow from the numbers: a time step above or far
     * below the limit, too few points in a cell, more disk or memory than is
     * usual.
     */
    void
    add_warnings();

    /// The report as an aligned table, then the warnings.
    std::string
    text() const;
  };
} // namespace mpm_granular::Output

#endif
