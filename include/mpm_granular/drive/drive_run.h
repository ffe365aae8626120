#ifndef mpm_granular_drive_drive_run_h
#define mpm_granular_drive_drive_run_h

#include <mpm_granular/drive/drive_parameters.h>
#include <mpm_granular/drive/loading.h>
#include <mpm_granular/output/run_folder.h>
#include <mpm_granular/parameters/run_info.h>
#include <mpm_granular/points/point_arrays.h>

#include <string>
#include <vector>

namespace mpm_granular::Drive
{
  /**
   * A test of one material point, for the calibration of a law: strains are
   * prescribed, or chosen such that a stress or the volume stays as it is. The
   * law is called as in any run. Every MPI rank does the same; the first one
   * writes.
   */
  class DriveRun
  {
  public:
    /// @throws InputError if the output folder cannot be used.
    DriveRun(const DriveParameters     &parameters,
             const Parameters::RunInfo &info);

    /**
     * Computes, then writes parameters.prm, drive.csv and yield.csv; with
     * RunInfo::check_only nothing of both.
     *
     * @throws ComputationError if no strain keeps what is to be kept; what was
     *   computed before is written.
     */
    void
    execute();

  private:
    /// Names of the columns of drive.csv.
    std::vector<std::string>
    columns() const;

    /// Everything up to the last strain.
    void
    compute();

    /// A step to the strain @p next_strain, forwards or backwards.
    void
    advance(const double next_strain);

    /// The point after a step with the factor @p adjustment, see Loading, and
    /// the dissipated energy [J/m^3].
    std::pair<Points::PointArrays<3>, double>
    after_step(const double adjustment, const double strain_increment) const;

    /// The factor with which what is to be kept stays.
    double
    find_adjustment(const double strain_increment) const;

    void
    add_row();

    void
    write_files() const;

    const DriveParameters               &parameters;
    const Parameters::RunInfo           &info;
    const Output::RunFolder              folder;
    const Materials::ConstitutiveLaw<3> &law;
    const Loading                        loading;

    Points::PointArrays<3>           point;
    Stress<3>                        initial_stress{};
    Stress<3>                        strain_tensor{}; ///< integral of d dt
    double                           time       = 0.;
    double                           strain     = 0.;
    double                           dissipated = 0.;
    double                           adjustment = 0.; ///< of the last step
    std::vector<std::vector<double>> rows;
  };
} // namespace mpm_granular::Drive

#endif
