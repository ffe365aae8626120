// The nodes of a mesh beyond what follows from the cells a rank has: which hang
// between which others, the boundary faces around them, their volumes.

#include <deal.II/lac/la_parallel_vector.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <mpm_granular/mesh/ask_owners.h>
#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/mesh/hanging_nodes.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <unordered_map>

namespace mpm_granular::Mesh
{
  using namespace dealii;

  namespace
  {
    using LocalNodes =
      std::unordered_map<types::global_dof_index, unsigned int>;

    /// The free nodes that a hanging node is a mean of, and their parts in it.
    using Mean = std::vector<std::pair<types::global_dof_index, double>>;

    /// A boundary face on its way to another rank.
    template <int dim>
    struct FaceMessage
    {
      std::array<types::global_dof_index, 1 << (dim - 1)> node;
      std::array<double, dim>                             normal;
      double                                              area;
      types::boundary_id                                  boundary;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &node &normal &area &boundary;
      }
    };

    /// What the owner of a node's DoF, who has all cells around it, knows.
    template <int dim>
    struct NodeMessage
    {
      std::array<double, dim>       position;
      Mean                          mean;  ///< empty if it does not hang
      std::vector<FaceMessage<dim>> faces; ///< around it

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int /*version*/)
      {
        archive &position &mean &faces;
      }
    };

    /// The boundary faces of this rank, to be told to others and completed by
    /// what they know.
    template <int dim>
    class FaceExchange
    {
    public:
      FaceExchange(const std::vector<types::global_dof_index> &global_nodes,
                   const LocalNodes                           &local_nodes,
                   std::vector<BoundaryFace<dim>>             &faces)
        : local_nodes(local_nodes)
        , faces(faces)
      {
        for (const auto &face : faces)
          {
            FaceMessage<dim> message;
            for (unsigned int k = 0; k < face.node.size(); ++k)
              {
                message.node[k] = global_nodes[face.node[k]];
                faces_of_node[message.node[k]].push_back(messages.size());
              }
            for (unsigned int d = 0; d < dim; ++d)
              message.normal[d] = face.normal[d];
            message.area     = face.area;
            message.boundary = face.boundary;
            messages.push_back(message);
            known.insert(key_of(message));
          }
      }

      /// Those around a node.
      std::vector<FaceMessage<dim>>
      around(const types::global_dof_index global) const
      {
        std::vector<FaceMessage<dim>> result;
        if (const auto found = faces_of_node.find(global);
            found != faces_of_node.end())
          for (const unsigned int face : found->second)
            result.push_back(messages[face]);
        return result;
      }

      /// Adds faces that are not known yet.
      void
      add(const std::vector<FaceMessage<dim>> &further)
      {
        for (const auto &message : further)
          {
            if (!known.insert(key_of(message)).second)
              continue;
            BoundaryFace<dim> face;
            face.cell     = unknown_cell;
            face.boundary = message.boundary;
            face.area     = message.area;
            for (unsigned int d = 0; d < dim; ++d)
              face.normal[d] = message.normal[d];
            for (const auto global : message.node)
              {
                const auto found = local_nodes.find(global);
                face.node.push_back(found == local_nodes.end() ? unknown_node :
                                                                 found->second);
              }
            faces.push_back(face);
          }
      }

    private:
      using Key = std::vector<types::global_dof_index>;

      static Key
      key_of(const FaceMessage<dim> &face)
      {
        Key key(face.node.begin(), face.node.end());
        std::sort(key.begin(), key.end());
        return key;
      }

      const LocalNodes               &local_nodes;
      std::vector<BoundaryFace<dim>> &faces;
      std::vector<FaceMessage<dim>>   messages; ///< of the faces at first
      std::map<types::global_dof_index, std::vector<unsigned int>>
                    faces_of_node;
      std::set<Key> known;
    };
  } // namespace

  template <int dim>
  void
  BackgroundMesh<dim>::complete_nodes()
  {
    LocalNodes local_nodes;
    for (unsigned int node = 0; node < n_nodes(); ++node)
      local_nodes[global_nodes[node]] = node;

    AffineConstraints<double> of_dofs;
    if (refinement->is_refined())
      of_dofs.copy_from(Mesh::hanging_nodes(dofs));
    const auto mean_of = [&](const types::global_dof_index global) {
      const auto *entries = of_dofs.n_constraints() > 0 ?
                              of_dofs.get_constraint_entries(global) :
                              nullptr;
      return entries == nullptr ? Mean() :
                                  Mean(entries->begin(), entries->end());
    };
    hanging.clear();
    const auto add_mean = [&](const unsigned int node, const Mean &mean) {
      if (mean.empty())
        return;
      hanging.add_line(node);
      for (const auto &[global, weight] : mean)
        {
          const auto [entry, is_new] = local_nodes.emplace(global, n_nodes());
          if (is_new)
            {
              global_nodes.push_back(global);
              node_positions.emplace_back();
            }
          hanging.add_entry(node, entry->second, weight);
        }
    };

    const unsigned int n_vertices = n_nodes();
    if (is_distributed())
      {
        const IndexSet   &owned = dofs.locally_owned_dofs();
        FaceExchange<dim> exchange(global_nodes, local_nodes, faces);
        const std::function<NodeMessage<dim>(const types::global_dof_index)>
          answer = [&](const types::global_dof_index global) {
            NodeMessage<dim>  message;
            const Point<dim> &x = node_positions[local_nodes.at(global)];
            for (unsigned int d = 0; d < dim; ++d)
              message.position[d] = x[d];
            message.mean  = mean_of(global);
            message.faces = exchange.around(global);
            return message;
          };

        GlobalIndices of_others;
        for (const auto global : global_nodes)
          if (!owned.is_element(global))
            of_others.push_back(global);
        const auto vertices =
          ask_owners(owned, of_others, communicator, answer);
        for (unsigned int node = 0; node < n_vertices; ++node)
          {
            const auto found = vertices.find(global_nodes[node]);
            add_mean(node,
                     found == vertices.end() ? mean_of(global_nodes[node]) :
                                               found->second.mean);
          }
        // Nodes that cells depend on without having them as vertices.
        const GlobalIndices farther(global_nodes.begin() + n_vertices,
                                    global_nodes.end());
        const auto others = ask_owners(owned, farther, communicator, answer);
        for (const auto &[global, message] : others)
          for (unsigned int d = 0; d < dim; ++d)
            node_positions[local_nodes.at(global)][d] = message.position[d];
        for (const auto *answers : {&vertices, &others})
          for (const auto &[global, message] : *answers)
            exchange.add(message.faces);
      }
    else
      for (unsigned int node = 0; node < n_vertices; ++node)
        add_mean(node, mean_of(global_nodes[node]));
    hanging.close();

    at_hanging.clear();
    if (hanging.n_constraints() == 0)
      return;
    at_hanging.resize(n_cells(), false);
    for (unsigned int cell = 0; cell < n_cells(); ++cell)
      for (const unsigned int node : nodes(cell))
        if (hanging.is_constrained(node))
          at_hanging[cell] = true;
  }

  template <int dim>
  void
  BackgroundMesh<dim>::find_node_volumes()
  {
    node_volumes.assign(n_nodes(), 0.);
    for (unsigned int cell = 0; cell < n_own; ++cell)
      {
        const auto   on_cell = nodes(cell);
        const double part    = volumes[cell] / on_cell.size();
        for (const unsigned int node : on_cell)
          if (const auto *entries = hanging.get_constraint_entries(node))
            for (const auto &[free, weight] : *entries)
              node_volumes[free] += weight * part;
          else
            node_volumes[node] += part;
      }
    if (!is_distributed())
      return;
    IndexSet      known(dofs.n_dofs());
    GlobalIndices sorted = global_nodes; // or adding them takes long
    std::sort(sorted.begin(), sorted.end());
    known.add_indices(sorted.begin(), sorted.end());
    LinearAlgebra::distributed::Vector<double> sums(dofs.locally_owned_dofs(),
                                                    known,
                                                    communicator);
    for (unsigned int node = 0; node < n_nodes(); ++node)
      sums[global_nodes[node]] += node_volumes[node];
    sums.compress(VectorOperation::add);
    sums.update_ghost_values();
    for (unsigned int node = 0; node < n_nodes(); ++node)
      node_volumes[node] = sums[global_nodes[node]];
  }

  template void
  BackgroundMesh<2>::complete_nodes();
  template void
  BackgroundMesh<3>::complete_nodes();
  template void
  BackgroundMesh<2>::find_node_volumes();
  template void
  BackgroundMesh<3>::find_node_volumes();
} // namespace mpm_granular::Mesh
