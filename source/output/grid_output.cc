#include <mpm_granular/output/grid_output.h>

namespace mpm_granular::Output
{
  using namespace dealii;

  template <int dim>
  GridOutput<dim>::GridOutput(const OutputParameters &parameters,
                              const MPI_Comm          communicator)
    : parameters(parameters)
    , is_first_rank(Utilities::MPI::this_mpi_process(communicator) == 0)
    , series(parameters.directory, "grid", communicator)
  {}



  template <int dim>
  void
  GridOutput<dim>::write(const double                     time,
                         const unsigned int               step,
                         const Mesh::BackgroundMesh<dim> &mesh,
                         const std::vector<Field>        &fields)
  {
    VtuContents<dim, dim> contents;
    contents.n_items = mesh.n_cells();
    contents.nodes   = [&mesh](const std::size_t cell) {
      std::array<std::size_t, dim + 1> nodes;
      for (unsigned int k = 0; k <= dim; ++k)
        nodes[k] = mesh.cell(cell).node[k];
      return nodes;
    };
    contents.position = [&mesh](const std::size_t node) {
      return mesh.node_position(node);
    };
    contents.fields = fields;

    DataOutBase::VtkFlags flags = parameters.vtk_flags();
    flags.time                  = time;
    flags.cycle                 = step;
    // The first rank has the whole mesh.
    series.add(time, [&](std::ostream &out) {
      if (is_first_rank)
        write_vtu(out, flags, contents, MPI_COMM_SELF);
    });
  }



  template class GridOutput<2>;
  template class GridOutput<3>;
} // namespace mpm_granular::Output
