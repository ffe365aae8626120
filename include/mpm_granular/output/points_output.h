#ifndef mpm_granular_output_points_output_h
#define mpm_granular_output_points_output_h

#include <mpm_granular/materials/constitutive_law.h>
#include <mpm_granular/output/file_series.h>
#include <mpm_granular/output/output_parameters.h>
#include <mpm_granular/points/point_arrays.h>

#include <cstddef>
#include <string>
#include <vector>

namespace mpm_granular::Output
{
  /// The laws of the points by material index.
  template <int dim>
  using Laws = std::vector<const Materials::ConstitutiveLaw<dim> *>;

  /**
   * All fields that can be written of @p points. The fields look at @p points
   * and @p laws, which must live as long.
   */
  template <int dim>
  std::vector<Field>
  point_fields(const Points::PointArrays<dim> &points, const Laws<dim> &laws);

  /// Writes the points as a series of files, points.pvd or points.xdmf.
  template <int dim>
  class PointsOutput
  {
  public:
    /**
     * @param parameters which fields, how compressed.
     * @param laws by material index; copied, but the laws must live as long.
     * @param communicator of the ranks that hold points.
     * @throws InputError if a field is asked for that does not exist.
     */
    PointsOutput(const OutputParameters &parameters,
                 const Laws<dim>        &laws,
                 const MPI_Comm          communicator);

    /**
     * Writes the next file. Collective.
     *
     * @param time [s].
     * @param step number of steps done.
     * @param points the points of this rank now.
     */
    void
    write(const double                    time,
          const unsigned int              step,
          const Points::PointArrays<dim> &points);

    /// Estimated size of a file of @p n_points points [bytes].
    double
    estimated_file_size(const std::size_t n_points) const;

    /// Names of the fields that are written.
    std::vector<std::string>
    field_names() const;

    unsigned int
    n_files() const
    {
      return series.n_files();
    }

    /// The files so far, for checkpoints.
    void
    serialize(Core::Archive &archive)
    {
      series.serialize(archive);
    }

    /// Goes on in the folder of an interrupted run, see FileSeries::resume().
    void
    resume()
    {
      series.resume();
    }

  private:
    /// The wanted ones among all fields.
    std::vector<Field>
    select(const std::vector<Field> &all) const;

    OutputParameters parameters;
    Laws<dim>        laws;
    FileSeries       series;
  };
} // namespace mpm_granular::Output

#endif
