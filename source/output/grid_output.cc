#include <mpm_granular/output/grid_output.h>

namespace mpm_granular::Output
{
  using namespace dealii;

  template <int dim>
  GridOutput<dim>::GridOutput(const OutputParameters &parameters,
                              const MPI_Comm          communicator)
    : series(parameters, "grid", communicator)
  {}



  template <int dim>
  void
  GridOutput<dim>::write(const double                     time,
                         const unsigned int               step,
                         const Mesh::BackgroundMesh<dim> &mesh,
                         const Mesh::Partition<dim>      &partition,
                         const std::vector<Field>        &fields)
  {
    constexpr unsigned int    none = numbers::invalid_unsigned_int;
    std::vector<unsigned int> cells, nodes, place(mesh.n_nodes(), none);
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      if (partition.is_owned(cell))
        {
          cells.push_back(cell);
          for (const unsigned int node : mesh.nodes(cell))
            if (place[node] == none)
              {
                place[node] = nodes.size();
                nodes.push_back(node);
              }
        }

    Contents<dim, dim> contents;
    contents.shape   = mesh.reference_cell();
    contents.n_items = cells.size();
    contents.n_nodes = nodes.size();
    contents.nodes   = [&](const std::size_t item) {
      ItemNodes<dim> of_item;
      for (const unsigned int node : mesh.nodes(cells[item]))
        of_item.push_back(place[node]);
      return of_item;
    };
    contents.position = [&](const std::size_t i) {
      return mesh.node_position(nodes[i]);
    };
    contents.fields = fields;
    for (auto &field : contents.fields)
      field.value = [&nodes, value = field.value](const std::size_t  i,
                                                  const unsigned int c) {
        return value(nodes[i], c);
      };
    series.add(time, step, contents);
  }



  template class GridOutput<2>;
  template class GridOutput<3>;
} // namespace mpm_granular::Output
