#include <mpm_granular/adaptivity/touching_cells.h>

#include <algorithm>
#include <numeric>

namespace mpm_granular::Adaptivity
{
  template <int dim>
  TouchingCells<dim>::TouchingCells(const Mesh::BackgroundMesh<dim> &mesh)
    : mesh(mesh)
    , first_of_node(mesh.n_nodes() + 1, 0)
  {
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      for (const unsigned int node : mesh.nodes(cell))
        ++first_of_node[node + 1];
    std::partial_sum(first_of_node.begin(),
                     first_of_node.end(),
                     first_of_node.begin());
    cells_of_nodes.resize(first_of_node.back());
    std::vector<unsigned int> next(first_of_node.begin(),
                                   first_of_node.end() - 1);
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      for (const unsigned int node : mesh.nodes(cell))
        cells_of_nodes[next[node]++] = cell;

    // The smaller of two cells knows the larger one as its neighbor.
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      for (const unsigned int other : mesh.neighbors(cell))
        {
          if (other >= mesh.n_cells())
            continue;
          const auto of_cell = mesh.nodes(cell), of_other = mesh.nodes(other);
          if (std::find_first_of(of_cell.begin(),
                                 of_cell.end(),
                                 of_other.begin(),
                                 of_other.end()) == of_cell.end())
            {
              beyond_faces[cell].push_back(other);
              beyond_faces[other].push_back(cell);
            }
        }
  }

  template class TouchingCells<2>;
  template class TouchingCells<3>;
} // namespace mpm_granular::Adaptivity
