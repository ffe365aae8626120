#ifndef mpm_granular_output_grid_output_h
#define mpm_granular_output_grid_output_h

#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/output/output_parameters.h>
#include <mpm_granular/output/vtu_file.h>

#include <vector>

namespace mpm_granular::Output
{
  /// Writes the background mesh with nodal fields as VTU files, grid.pvd.
  template <int dim>
  class GridOutput
  {
  public:
    /// @param parameters where to, how compressed.
    explicit GridOutput(const OutputParameters &parameters);

    /**
     * Writes the next file.
     *
     * @param time [s].
     * @param step number of steps done.
     * @param mesh the background mesh.
     * @param fields values by node (DoF index of mesh.dof_handler()), say
     *   `{"mass", "kg", 1, [&](auto node, auto) { return mass[node]; }}`.
     */
    void
    write(const double                     time,
          const unsigned int               step,
          const Mesh::BackgroundMesh<dim> &mesh,
          const std::vector<Field>        &fields);

  private:
    OutputParameters parameters;
    VtuSeries        series;
  };
} // namespace mpm_granular::Output

#endif
