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
   * Which MPI rank owns which cell. Every rank holds the whole mesh (as with
   * deal.II's parallel::shared::Triangulation) and knows all owners.
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
    /// Another rank and the nodes that both may have points around, ascending:
    /// the same list on both ranks.
    struct Neighbor
    {
      unsigned int              rank;
      std::vector<unsigned int> nodes;
    };

    /// Shares the cells out evenly.
    Partition(const PartitionParameters &parameters,
              const BackgroundMesh<dim> &mesh,
              const MPI_Comm             communicator);

    /**
     * Shares the cells out anew.
     *
     * @param n_points number of points of each cell, over all ranks, the same
     *   on all ranks: what each rank should have equally much of.
     */
    void
    distribute(const std::vector<std::uint32_t> &n_points);

    /// The owners of all cells, for checkpoints.
    void
    serialize(Core::Archive &archive);

    unsigned int
    owner(const unsigned int cell) const
    {
      return owners[cell];
    }

    bool
    is_owned(const unsigned int cell) const
    {
      return owners[cell] == rank;
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

  private:
    void
    cut_curve(const std::vector<std::uint32_t> &n_points);
    void
    cut_graph(const std::vector<std::uint32_t> &n_points);
    void
    find_neighbors();

    const std::string          method;
    const BackgroundMesh<dim> &mesh;
    std::vector<std::uint32_t> owners;    ///< by cell
    std::vector<bool>          reachable; ///< by cell
    std::vector<Neighbor>      all_neighbors;
  };
} // namespace mpm_granular::Mesh

#endif
