#ifndef mpm_granular_output_grid_output_h
#define mpm_granular_output_grid_output_h

#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/output/file_series.h>
#include <mpm_granular/output/output_parameters.h>

#include <vector>

namespace mpm_granular::Output
{
  /// Writes the background mesh with nodal fields as a series of files,
  /// grid.pvd or grid.xdmf. The first rank has the whole mesh and all values.
  template <int dim>
  class GridOutput
  {
  public:
    /// @param parameters where to, in which format; the one file of the
    ///   first rank is VTU also with the format PVTU.
    /// @param communicator of the ranks that call write().
    GridOutput(const OutputParameters &parameters, const MPI_Comm communicator);

    /**
     * Writes the next file. Collective.
     *
     * @param time [s].
     * @param step number of steps done.
     * @param mesh the background mesh.
     * @param fields only the first rank's are used; values by node (DoF index of mesh.dof_handler()), say
     *   `{"mass", "kg", 1, [&](auto node, auto) { return mass[node]; }}`.
     */
    void
    write(const double                     time,
          const unsigned int               step,
          const Mesh::BackgroundMesh<dim> &mesh,
          const std::vector<Field>        &fields);

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
    bool       is_first_rank;
    FileSeries series;
  };
} // namespace mpm_granular::Output

#endif
