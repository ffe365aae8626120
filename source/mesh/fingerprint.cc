#include <mpm_granular/core/hash.h>
#include <mpm_granular/mesh/fingerprint.h>

namespace mpm_granular::Mesh
{
  using namespace dealii;
  using Core::combined;

  namespace
  {
    /// The hash of some nodes, the same for any order of them.
    template <int dim, class Nodes>
    std::uint64_t
    hash_of_nodes(const BackgroundMesh<dim> &mesh, const Nodes &nodes)
    {
      std::uint64_t sum = 0;
      for (const unsigned int node : nodes)
        {
          std::uint64_t of_node = 0;
          for (unsigned int d = 0; d < dim; ++d)
            of_node =
              combined(of_node, Core::hash(mesh.node_position(node)[d]));
          sum += of_node;
        }
      return Core::mixed(sum);
    }
  } // namespace

  template <int dim>
  std::uint64_t
  fingerprint(const BackgroundMesh<dim> &mesh, const MPI_Comm communicator)
  {
    std::uint64_t cells = 0, faces = 0, names = 0;
    for (unsigned int cell = 0; cell < mesh.n_own_cells(); ++cell)
      cells +=
        combined(mesh.global_cell(cell), hash_of_nodes(mesh, mesh.nodes(cell)));
    for (const auto &face : mesh.boundary_faces())
      if (face.cell < mesh.n_own_cells())
        faces += combined(face.boundary, hash_of_nodes(mesh, face.node));
    if (mesh.is_distributed())
      {
        cells = Utilities::MPI::sum(cells, communicator);
        faces = Utilities::MPI::sum(faces, communicator);
      }
    for (const auto &[name, id] : mesh.boundary_names())
      names += combined(id, Core::hash(name));

    std::uint64_t result =
      combined(mesh.n_global_cells(), mesh.n_global_nodes());
    for (const std::uint64_t part : {cells, faces, names})
      result = combined(result, part);
    return result;
  }

  template std::uint64_t
  fingerprint(const BackgroundMesh<2> &, const MPI_Comm);
  template std::uint64_t
  fingerprint(const BackgroundMesh<3> &, const MPI_Comm);
} // namespace mpm_granular::Mesh
