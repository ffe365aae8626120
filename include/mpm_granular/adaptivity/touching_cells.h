#ifndef mpm_granular_adaptivity_touching_cells_h
#define mpm_granular_adaptivity_touching_cells_h

#include <mpm_granular/mesh/background_mesh.h>

#include <map>
#include <vector>

namespace mpm_granular::Adaptivity
{
  /// Which cells touch each other: those with a common vertex, and those on the
  /// two sides of a face of which the larger cell has no vertex.
  template <int dim>
  class TouchingCells
  {
  public:
    explicit TouchingCells(const Mesh::BackgroundMesh<dim> &mesh);

    /// Calls @p action with the cells that touch a cell, among them itself;
    /// with some of them several times. Those of an own cell are all on this
    /// rank, those of a ghost cell may not be.
    template <class Action>
    void
    for_each(const unsigned int cell, Action &&action) const
    {
      for (const unsigned int node : mesh.nodes(cell))
        for (unsigned int i = first_of_node[node]; i < first_of_node[node + 1];
             ++i)
          action(cells_of_nodes[i]);
      if (const auto found = beyond_faces.find(cell);
          found != beyond_faces.end())
        for (const unsigned int other : found->second)
          action(other);
    }

    /// Whether some touch a cell without a common vertex.
    bool
    has_others_beyond_faces(const unsigned int cell) const
    {
      return beyond_faces.count(cell) > 0;
    }

  private:
    const Mesh::BackgroundMesh<dim> &mesh;

    std::vector<unsigned int> first_of_node; ///< into cells_of_nodes
    std::vector<unsigned int> cells_of_nodes;

    /// Those that touch without a common vertex: the cell of the middle of a
    /// refined triangle.
    std::map<unsigned int, std::vector<unsigned int>> beyond_faces;
  };
} // namespace mpm_granular::Adaptivity

#endif
