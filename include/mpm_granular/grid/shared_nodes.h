#ifndef mpm_granular_grid_shared_nodes_h
#define mpm_granular_grid_shared_nodes_h

#include <mpm_granular/mesh/partition.h>

#include <cstdint>
#include <vector>

namespace mpm_granular::Grid
{
  /**
   * Sums over the ranks at nodes that several of them have points around.
   *
   * All ranks that share a node get the same sum to the last bit, because all
   * add in the order of the ranks; so what follows from it is computed by each
   * of them alone. One message to each neighbour per sum, with active nodes
   * only.
   */
  template <int dim>
  class SharedNodes
  {
  public:
    explicit SharedNodes(const Mesh::Partition<dim> &partition);

    /**
     * Finds the nodes that are active here and elsewhere, and sums their
     * values. To be called by all ranks, after the active nodes have changed.
     *
     * @param slot_of gives the slot of a node of the mesh, or no_slot if it is
     *   not active.
     * @param n_slots number of active nodes.
     * @param values @p n_values numbers per active node, by slot.
     */
    template <class SlotOf>
    void
    find_and_sum(SlotOf           &&slot_of,
                 const unsigned int n_slots,
                 double            *values,
                 const unsigned int n_values)
    {
      n_active = n_slots;
      links.resize(partition.neighbors().size());
      for (unsigned int n = 0; n < links.size(); ++n)
        {
          const auto &nodes = partition.neighbors()[n].nodes;
          links[n].slots.resize(nodes.size());
          for (unsigned int i = 0; i < nodes.size(); ++i)
            links[n].slots[i] = slot_of(nodes[i]);
        }
      exchange_active(values, n_values);
    }

    /// Sums further values at the nodes found before.
    void
    sum(double *values, const unsigned int n_values);

    /// The same for a vector field.
    void
    sum(std::vector<dealii::Tensor<1, dim>> &field);

    /**
     * Completes values of nodes that are set by the rank that counts the node
     * and zero elsewhere: each rank then has those of all nodes of its own
     * cells.
     *
     * @param values @p n_values numbers per node of the mesh.
     */
    void
    spread(std::vector<double> &values, const unsigned int n_values);

    /// Whether this rank counts the node in sums over all nodes: the first of
    /// those that share it does.
    bool
    counts(const unsigned int slot) const
    {
      return partition.n_ranks == 1 || is_first[slot];
    }

    bool
    is_serial() const
    {
      return partition.n_ranks == 1;
    }

    MPI_Comm
    communicator() const
    {
      return partition.communicator;
    }

    /// What this rank has sent so far.
    struct Traffic
    {
      std::uint64_t n_messages = 0;
      std::uint64_t n_bytes    = 0;
    };

    const Traffic &
    traffic() const
    {
      return sent;
    }

    static constexpr unsigned int no_slot = static_cast<unsigned int>(-1);

  private:
    /// The nodes in common with a neighbour. The message of a first sum begins
    /// with the active ones of the list, as bits; then come the values of
    /// these.
    struct Link
    {
      std::vector<unsigned int> slots;  ///< of the neighbour's list
      std::vector<unsigned int> common; ///< slots of nodes active on both
      std::vector<unsigned int> place;  ///< of the common nodes in a message
      std::vector<double>       outgoing;
      std::vector<double>       incoming;
    };

    void
    exchange_active(double *values, const unsigned int n_values);
    void
    exchange_messages();
    void
    add_up(double *values, const unsigned int n_values);

    const Mesh::Partition<dim> &partition;
    unsigned int                n_active = 0;
    std::vector<Link>           links;    ///< by neighbour
    std::vector<unsigned int>   shared;   ///< slots in any link
    std::vector<char>           is_first; ///< by slot
    std::vector<double>         totals;   ///< by slot
    std::vector<double>         packed;   ///< a vector field, by slot
    Traffic                     sent;
  };
} // namespace mpm_granular::Grid

#endif
