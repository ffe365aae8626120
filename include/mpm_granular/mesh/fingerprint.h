#ifndef mpm_granular_mesh_fingerprint_h
#define mpm_granular_mesh_fingerprint_h

#include <mpm_granular/mesh/background_mesh.h>

#include <cstdint>

namespace mpm_granular::Mesh
{
  /**
   * A number that tells whether a mesh is the same as another one: it depends
   * on the numbers of cells and nodes, the vertices of each cell, the order of
   * the cells, and the boundaries with their names; not on the ranks.
   * Collective.
   */
  template <int dim>
  std::uint64_t
  fingerprint(const BackgroundMesh<dim> &mesh, const MPI_Comm communicator);
} // namespace mpm_granular::Mesh

#endif
