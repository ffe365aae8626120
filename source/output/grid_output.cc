#include <mpm_granular/output/grid_output.h>

namespace mpm_granular::Output
{
  using namespace dealii;

  template <int dim>
  GridOutput<dim>::GridOutput(const OutputParameters &parameters,
                              const MPI_Comm          communicator)
    : parameters(parameters)
    , series(parameters.directory, "grid", communicator)
  {}



  template <int dim>
  void
  GridOutput<dim>::write(const double                     time,
                         const unsigned int               step,
                         const Mesh::BackgroundMesh<dim> &mesh,
                         const Mesh::Partition<dim>      &partition,
                         const std::vector<Field>        &fields)
  {
    VtuContents<dim, dim>     contents;
    std::vector<unsigned int> own_cells;
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      if (partition.is_owned(cell))
        own_cells.push_back(cell);
    contents.n_items = own_cells.size();
    contents.nodes   = [&](const std::size_t item) {
      const auto nodes = mesh.nodes(own_cells[item]);
      return ItemNodes<dim>(nodes.begin(), nodes.end());
    };
    contents.position = [&mesh](const std::size_t node) {
      return mesh.node_position(node);
    };
    contents.fields = fields;

    DataOutBase::VtkFlags flags = parameters.vtk_flags();
    flags.time                  = time;
    flags.cycle                 = step;
    series.add(time, [&](std::ostream &out) {
      write_vtu(out, flags, contents, partition.communicator);
    });
  }



  template class GridOutput<2>;
  template class GridOutput<3>;
} // namespace mpm_granular::Output
