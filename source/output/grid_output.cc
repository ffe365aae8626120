#include <mpm_granular/output/grid_output.h>

namespace mpm_granular::Output
{
  using namespace dealii;

  namespace
  {
    /// The first rank writes alone.
    OutputParameters
    in_one_file(OutputParameters parameters)
    {
      if (parameters.format == "PVTU")
        parameters.format = "VTU";
      return parameters;
    }
  } // namespace

  template <int dim>
  GridOutput<dim>::GridOutput(const OutputParameters &parameters,
                              const MPI_Comm          communicator)
    : is_first_rank(Utilities::MPI::this_mpi_process(communicator) == 0)
    , series(in_one_file(parameters), "grid", communicator)
  {}



  template <int dim>
  void
  GridOutput<dim>::write(const double                     time,
                         const unsigned int               step,
                         const Mesh::BackgroundMesh<dim> &mesh,
                         const std::vector<Field>        &fields)
  {
    Contents<dim, dim> contents;
    contents.n_items = is_first_rank ? mesh.n_cells() : 0;
    contents.n_nodes = is_first_rank ? mesh.n_nodes() : 0;
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
    series.add(time, step, contents);
  }



  template class GridOutput<2>;
  template class GridOutput<3>;
} // namespace mpm_granular::Output
