#ifndef mpm_granular_output_grid_output_h
#define mpm_granular_output_grid_output_h

#include <mpm_granular/mesh/partition.h>
#include <mpm_granular/output/file_series.h>
#include <mpm_granular/output/output_parameters.h>

#include <vector>

namespace mpm_granular::Output
{
  /// Writes the background mesh with nodal fields as a series of files,
  /// grid.pvd or grid.xdmf.
  template <int dim>
  class GridOutput
  {
  public:
    /// @param parameters where to, in which format.
    /// @param communicator of the ranks that call write().
    GridOutput(const OutputParameters &parameters, const MPI_Comm communicator);

    /**
     * Writes the next file. Collective.
     *
     * @param time [s].
     * @param step number of steps done.
     * @param mesh the background mesh.
     * @param partition each rank writes its own cells.
     * @param fields values by node of the mesh, say
     *   `{"mass", "kg", 1, [&](auto node, auto) { return mass[node]; }}`.
     */
    void
    write(const double                     time,
          const unsigned int               step,
          const Mesh::BackgroundMesh<dim> &mesh,
          const Mesh::Partition<dim>      &partition,
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
    FileSeries series;
  };
} // namespace mpm_granular::Output

#endif
