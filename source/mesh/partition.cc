#include <deal.II/base/parameter_handler.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <mpm_granular/mesh/ask_owners.h>
#include <mpm_granular/mesh/partition.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <unordered_map>

namespace mpm_granular::Mesh
{
  using namespace dealii;

  namespace
  {
    using Ranks = std::vector<std::uint32_t>;

    bool
    contains(const Ranks &list, const std::uint32_t rank)
    {
      return std::find(list.begin(), list.end(), rank) != list.end();
    }

    /// Adds ranks to a short list without repetition.
    void
    insert(Ranks &list, const Ranks &more)
    {
      for (const auto rank : more)
        if (!contains(list, rank))
          list.push_back(rank);
    }

    /// The nodes of a distributed mesh that other ranks may know too: those of
    /// cells that have a node in common with a ghost cell.
    template <int dim>
    std::vector<unsigned int>
    nodes_near_ghosts(const BackgroundMesh<dim> &mesh)
    {
      std::vector<bool> of_ghosts(mesh.n_nodes(), false);
      const auto mark = [&](const unsigned int cell, std::vector<bool> &marks) {
        for (const unsigned int node : mesh.nodes(cell))
          marks[node] = true;
        for (const unsigned int node : mesh.free_nodes(cell))
          marks[node] = true;
      };
      for (unsigned int cell = mesh.n_own_cells(); cell < mesh.n_cells();
           ++cell)
        mark(cell, of_ghosts);

      std::vector<bool> are_near = of_ghosts;
      for (unsigned int cell = 0; cell < mesh.n_own_cells(); ++cell)
        {
          const auto nodes = mesh.free_nodes(cell);
          if (std::any_of(nodes.begin(), nodes.end(), [&](const auto node) {
                return of_ghosts[node];
              }))
            mark(cell, are_near);
        }
      std::vector<unsigned int> result;
      for (unsigned int node = 0; node < mesh.n_nodes(); ++node)
        if (are_near[node])
          result.push_back(node);
      return result;
    }

    /// Adds to the ranks known at each node of a distributed mesh those that
    /// others know of.
    template <int dim>
    void
    complete_at_nodes(const BackgroundMesh<dim> &mesh,
                      std::vector<Ranks>        &of_nodes)
    {
      if (!mesh.is_distributed())
        return;
      using Global                 = types::global_dof_index;
      const IndexSet &owned        = mesh.dof_handler().locally_owned_dofs();
      const MPI_Comm  communicator = mesh.mpi_communicator();

      GlobalIndices                            known;
      std::unordered_map<Global, unsigned int> local;
      for (const unsigned int node : nodes_near_ghosts(mesh))
        {
          known.push_back(mesh.global_node(node));
          local[known.back()] = node;
        }
      std::map<unsigned int, std::vector<std::pair<Global, Ranks>>> reports;
      for (const auto &[rank, nodes] : by_owner(owned, known, communicator))
        for (const Global node : nodes)
          reports[rank].emplace_back(node, of_nodes[local.at(node)]);
      for (const auto &[rank, of_rank] :
           Utilities::MPI::some_to_some(communicator, reports))
        for (const auto &[node, ranks] : of_rank)
          insert(of_nodes[local.at(node)], ranks);
      for (const auto &[node, ranks] : ask_owners<Ranks>(
             owned, known, communicator, [&](const Global node) {
               return of_nodes[local.at(node)];
             }))
        of_nodes[local.at(node)] = ranks;
    }

    /// The ranks that own each cell, or have it as a ghost.
    template <int dim>
    std::vector<Ranks>
    ranks_seeing(const Partition<dim>      &partition,
                 const BackgroundMesh<dim> &mesh,
                 const std::vector<Ranks>  &owning)
    {
      std::vector<Ranks> seeing(mesh.n_cells());
      if (!mesh.is_distributed())
        {
          for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
            for (const unsigned int node : mesh.free_nodes(cell))
              insert(seeing[cell], owning[node]);
          return seeing;
        }
      std::map<unsigned int, std::vector<unsigned int>> ghosts;
      for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
        if (const auto global = mesh.global_cell(cell);
            partition.is_owned(cell))
          seeing[cell] = {partition.rank};
        else
          ghosts[partition.owner(global)].push_back(global);
      for (const auto &[rank, cells] :
           Utilities::MPI::some_to_some(mesh.mpi_communicator(), ghosts))
        for (const unsigned int global : cells)
          seeing[mesh.local_cell(global)].push_back(rank);
      mesh.template send_to_ghosts<Ranks>(
        [&](const unsigned int cell) { return seeing[cell]; },
        [&](const unsigned int cell, const Ranks &ranks) {
          seeing[cell] = ranks;
        });
      return seeing;
    }

    /// The ranks known at each node or at a node that a cell joins it with.
    template <int dim>
    std::vector<Ranks>
    spread_over_cells(const BackgroundMesh<dim> &mesh,
                      const std::vector<Ranks>  &of_nodes)
    {
      std::vector<Ranks> spread(of_nodes.size());
      for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
        {
          Ranks of_cell;
          for (const unsigned int node : mesh.nodes(cell))
            insert(of_cell, of_nodes[node]);
          for (const unsigned int node : mesh.nodes(cell))
            insert(spread[node], of_cell);
        }
      return spread;
    }

    template <class Key>
    void
    sort_by(std::vector<unsigned int> &list, Key &&key)
    {
      std::sort(list.begin(), list.end(), [&](const auto a, const auto b) {
        return key(a) < key(b);
      });
    }
  } // namespace

  void
  PartitionParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Partition",
                      method,
                      "How the cells are shared out among MPI processes, with "
                      "equal numbers of points: in pieces of a space-filling "
                      "curve, or by METIS, whose pieces have shorter common "
                      "surfaces but take longer to find. Hypercubes are always "
                      "shared out by p4est, along a curve.",
                      Patterns::Selection("space-filling curve|METIS"));
    prm.add_parameter("Largest imbalance",
                      largest_imbalance,
                      "The cells are shared out anew when the process with the "
                      "most points has this part more than the mean. "
                      "Units: none.",
                      Patterns::Double(0.));
  }

  template <int dim>
  Partition<dim>::Partition(const PartitionParameters &parameters,
                            BackgroundMesh<dim>       &mesh,
                            const MPI_Comm             communicator,
                            const bool                 acts_beyond_cells)
    : communicator(communicator)
    , rank(Utilities::MPI::this_mpi_process(communicator))
    , n_ranks(Utilities::MPI::n_mpi_processes(communicator))
    , largest_imbalance(parameters.largest_imbalance)
    , acts_beyond_cells(acts_beyond_cells)
    , method(parameters.method)
    , mesh(mesh)
  {
    distribute(std::vector<std::uint32_t>(mesh.n_cells(), 1));
  }

  template <int dim>
  void
  Partition<dim>::distribute(const std::vector<std::uint32_t> &n_points)
  {
    AssertDimension(n_points.size(), mesh.n_cells());
    if (!mesh.is_distributed())
      owners.assign(mesh.n_cells(), 0);
    if (n_ranks == 1)
      {
        reachable.assign(mesh.n_cells(), true);
        own_nodes.assign(mesh.n_nodes(), true);
        return;
      }
    if (mesh.is_distributed())
      {
        // Cells without points cost little, but not nothing.
        constexpr unsigned int     cost_of_point = 100;
        std::vector<std::uint32_t> cost;
        for (unsigned int cell = 0; cell < mesh.n_own_cells(); ++cell)
          cost.push_back(1 + cost_of_point * n_points[cell]);
        share_out(cost);
      }
    else if (method == "METIS")
      cut_graph(n_points);
    else
      cut_curve(n_points);
    find_neighbors();
  }

  template <int dim>
  void
  Partition<dim>::serialize(Core::Archive &archive)
  {
    if (!mesh.is_distributed())
      archive.replicated("mesh/owners", owners);
    else
      {
        // The weights say who owns what. They are written by those that owned
        // the cells then, in the order of the cells; they go to those that own
        // them now.
        std::vector<std::uint32_t> written = weights;
        archive.distributed("weights/of_cells", written);
        if (archive.is_reading() && n_ranks > 1)
          {
            const auto sizes =
              Utilities::MPI::all_gather(communicator,
                                         unsigned(written.size()));
            unsigned int global =
              std::accumulate(sizes.begin(), sizes.begin() + rank, 0u);
            std::map<unsigned int, std::vector<std::uint32_t>> parts;
            for (const auto weight : written)
              parts[mesh.owner(global++)].push_back(weight);
            std::vector<std::uint32_t> of_own_cells;
            for (const auto &[other, part] :
                 Utilities::MPI::some_to_some(communicator, parts))
              of_own_cells.insert(of_own_cells.end(), part.begin(), part.end());
            share_out(of_own_cells);
          }
      }
    if (archive.is_reading() && n_ranks > 1)
      find_neighbors();
  }

  template <int dim>
  void
  Partition<dim>::cut_curve(const std::vector<std::uint32_t> &n_points)
  {
    // Cells are numbered along the curve. A cell goes to the rank in whose
    // share of all points the middle of its own points falls.
    std::uint64_t total = 0;
    for (const auto n : n_points)
      total += n;
    std::uint64_t before = 0;
    for (unsigned int cell = 0; cell < n_points.size(); ++cell)
      {
        const double middle = before + 0.5 * n_points[cell];
        owners[cell] =
          std::min<std::uint32_t>(middle / total * n_ranks, n_ranks - 1);
        before += n_points[cell];
      }
  }

  template <int dim>
  void
  Partition<dim>::cut_graph(const std::vector<std::uint32_t> &n_points)
  {
    DynamicSparsityPattern connections(mesh.n_cells());
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      for (const unsigned int neighbor : mesh.neighbors(cell))
        if (neighbor != no_cell)
          {
            // A cell does not name all of its smaller neighbors, but they do.
            connections.add(cell, neighbor);
            connections.add(neighbor, cell);
          }
    SparsityPattern graph;
    graph.copy_from(connections);
    SparsityTools::partition(
      graph, n_points, n_ranks, owners, SparsityTools::Partitioner::metis);
  }

  template <int dim>
  void
  Partition<dim>::share_out(const std::vector<std::uint32_t> &new_weights)
  {
    weights = new_weights;
    mesh.repartition(weights);
  }

  template <int dim>
  void
  Partition<dim>::find_neighbors()
  {
    // The ranks that own a cell that depends on a node; then, those that own or
    // see each cell; then, those that may have points around each node.
    std::vector<Ranks> owning(mesh.n_nodes());
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      for (const unsigned int node : mesh.free_nodes(cell))
        insert(owning[node], {owner(mesh.global_cell(cell))});
    complete_at_nodes(mesh, owning);
    const std::vector<Ranks> seeing = ranks_seeing(*this, mesh, owning);
    std::vector<Ranks>       meeting(mesh.n_nodes());
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      for (const unsigned int node : mesh.free_nodes(cell))
        insert(meeting[node], seeing[cell]);
    complete_at_nodes(mesh, meeting);
    if (acts_beyond_cells)
      meeting = spread_over_cells(mesh, meeting);

    reachable.resize(mesh.n_cells());
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      reachable[cell] = contains(seeing[cell], rank);
    own_nodes.resize(mesh.n_nodes());
    for (unsigned int node = 0; node < mesh.n_nodes(); ++node)
      own_nodes[node] = contains(owning[node], rank);

    std::map<unsigned int, Neighbor> by_rank;
    for (unsigned int node = 0; node < mesh.n_nodes(); ++node)
      if (contains(meeting[node], rank))
        for (const auto other : meeting[node])
          if (other != rank)
            by_rank[other].nodes.places.push_back(node);
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      if (reachable[cell])
        for (const auto other : seeing[cell])
          if (other != rank)
            by_rank[other].cells.places.push_back(cell);

    all_neighbors.clear();
    for (auto &[other, neighbor] : by_rank)
      {
        neighbor.rank = other;
        auto &nodes   = neighbor.nodes;
        sort_by(nodes.places,
                [&](const auto node) { return mesh.global_node(node); });
        for (const unsigned int node : nodes.places)
          nodes.are_its_own.push_back(contains(owning[node], other));
        auto &cells = neighbor.cells;
        sort_by(cells.places,
                [&](const auto cell) { return mesh.global_cell(cell); });
        for (const unsigned int cell : cells.places)
          cells.are_its_own.push_back(owner(mesh.global_cell(cell)) == other);
        all_neighbors.push_back(std::move(neighbor));
      }
  }

  template class Partition<2>;
  template class Partition<3>;
} // namespace mpm_granular::Mesh
