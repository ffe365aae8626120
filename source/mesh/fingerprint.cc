#include <mpm_granular/core/hash.h>
#include <mpm_granular/mesh/fingerprint.h>

namespace mpm_granular::Mesh
{
  using namespace dealii;
  using Core::combined;

  namespace
  {
    /// The hash of some nodes, the same for any order of them.
    template <int dim, std::size_t n_nodes>
    std::uint64_t
    hash_of_nodes(const BackgroundMesh<dim>               &mesh,
                  const std::array<unsigned int, n_nodes> &nodes)
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
  fingerprint(const BackgroundMesh<dim> &mesh)
  {
    std::uint64_t cells = 0, faces = 0, names = 0;
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      cells = combined(cells, hash_of_nodes(mesh, mesh.cell(cell).node));
    for (const auto &face : mesh.boundary_faces())
      faces += combined(face.boundary, hash_of_nodes(mesh, face.node));
    for (const auto &[name, id] : mesh.boundary_names())
      names += combined(id, Core::hash(name));

    std::uint64_t result = combined(mesh.n_cells(), mesh.n_nodes());
    for (const std::uint64_t part : {cells, faces, names})
      result = combined(result, part);
    return result;
  }

  template std::uint64_t
  fingerprint(const BackgroundMesh<2> &);
  template std::uint64_t
  fingerprint(const BackgroundMesh<3> &);
} // namespace mpm_granular::Mesh
