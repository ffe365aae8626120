#ifndef mpm_granular_mesh_partition_h
#define mpm_granular_mesh_partition_h

#include <deal.II/base/mpi.h>

#include <mpm_granular/core/archive.h>
#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/parameters/parameter_group.h>

#include <cstdint>
#include <string>
#include <vector>

namespace mpm_granular::Mesh
{
  /// How cells are shared out among the ranks.
  struct PartitionParameters : Parameters::ParameterGroup
  {
    std::string method            = "space-filling curve";
    double      largest_imbalance = 0.05; ///< that is put up with

    void
    add_parameters(dealii::ParameterHandler &prm) override;
  };

  /**
   * Which MPI rank owns which cell. Of a mesh of simplices every rank holds all
   * cells (as with deal.II's parallel::shared::Triangulation) and knows all
   * owners; a distributed mesh is shared out by p4est.
   *
   * The points of a rank are in its own cells or in *ghost* cells, which share
   * a vertex with an own cell; a point that comes farther has to move to the
   * rank that owns its cell. So the nodes that a rank can ever meet between two
   * migrations, and the ranks it can meet them with, follow from the partition.
   */
  template <int dim>
  class Partition
  {
  public:
    /// Nodes or cells that this and another rank may both meet, in the order of
    /// their global numbers: the same list on both ranks.
    struct CommonPlaces
    {
      std::vector<unsigned int> places;

      /// Whether they belong to the other rank: a cell that it owns, a node of
      /// such a cell.
      std::vector<bool> are_its_own;
    };

    /// Another rank and what both may have points in (cells) or around (nodes).
    struct Neighbor
    {
      unsigned int rank;
      CommonPlaces nodes;
      CommonPlaces cells;
    };

    /// Shares the cells out evenly.
    /// @param acts_beyond_cells whether points meet not only the nodes of their
    ///   cells but also those of the cells around; on simplices only.
    Partition(const PartitionParameters &parameters,
              BackgroundMesh<dim>       &mesh,
              const MPI_Comm             communicator,
              const bool                 acts_beyond_cells = false);

    /**
     * Shares the cells out anew; flat indices of cells and nodes of a
     * distributed mesh change. Collective.
     *
     * @param n_points number of points of each cell, over all ranks: what each
     *   rank should have equally much of. The ghosts of a distributed mesh do
     *   not count.
     */
    void
    distribute(const std::vector<std::uint32_t> &n_points);

    /// Who owns which cell, for checkpoints.
    void
    serialize(Core::Archive &archive);

    /// The owner of any cell, by its global number.
    unsigned int
    owner(const unsigned int global_cell) const
    {
      return mesh.is_distributed() ? mesh.owner(global_cell) :
                                     owners[global_cell];
    }

    bool
    is_owned(const unsigned int cell) const
    {
      return mesh.is_distributed() ? cell < mesh.n_own_cells() :
                                     owners[cell] == rank;
    }

    /// Whether the node is one of a cell that this rank owns.
    bool
    is_of_own_cell(const unsigned int node) const
    {
      return own_nodes[node];
    }

    /// Whether points of this rank may be in the cell: an own or a ghost cell.
    bool
    is_reachable(const unsigned int cell) const
    {
      return reachable[cell];
    }

    /// The other ranks with common nodes, ascending.
    const std::vector<Neighbor> &
    neighbors() const
    {
      return all_neighbors;
    }

    const MPI_Comm     communicator;
    const unsigned int rank;    ///< of this process
    const unsigned int n_ranks; ///< of all processes

    /// The largest number of points of a rank over the mean, less one, above
    /// which it is worth to distribute anew.
    const double largest_imbalance;

    /// Whether points meet the nodes of the cells around theirs.
    const bool acts_beyond_cells;

  private:
    void
    cut_curve(const std::vector<std::uint32_t> &n_points);
    void
    cut_graph(const std::vector<std::uint32_t> &n_points);
    void
    share_out(const std::vector<std::uint32_t> &weights);
    void
    find_neighbors();

    const std::string          method;
    BackgroundMesh<dim>       &mesh;
    std::vector<std::uint32_t> owners;    ///< by cell; not if distributed
    std::vector<std::uint32_t> weights;   ///< of all cells of p4est, in order
    std::vector<bool>          reachable; ///< by cell
    std::vector<bool>          own_nodes; ///< of own cells, by node
    std::vector<Neighbor>      all_neighbors;
  };
} // namespace mpm_granular::Mesh

#endif
