#ifndef mpm_granular_grid_shared_sums_h
#define mpm_granular_grid_shared_sums_h

#include <mpm_granular/core/lanes.h>
#include <mpm_granular/mesh/partition.h>

#include <array>
#include <cstdint>
#include <vector>

namespace mpm_granular::Grid
{
  /**
   * Sums over the ranks at nodes that several of them have points around, or in
   * cells that several of them have points in: "places".
   *
   * A place that is active on any rank is also active on the ranks it belongs
   * to, so the owner of a cell has all there is to know of it. All ranks that
   * share a place get the same sum to the last bit, because all add in the
   * order of the ranks; so what follows from it is computed by each of them
   * alone. One message to each neighbour per sum, with active places only.
   */
  template <int dim>
  class SharedSums
  {
  public:
    using Neighbor = typename Mesh::Partition<dim>::Neighbor;
    using Places   = typename Mesh::Partition<dim>::CommonPlaces;

    /// @param places which ones: &Neighbor::nodes or &Neighbor::cells.
    SharedSums(const Mesh::Partition<dim> &partition,
               const Places Neighbor::*places);

    /**
     * Finds the places that are active here and elsewhere, and sums their
     * values. To be called by all ranks, after the active places have changed.
     *
     * @param slot_of gives the slot of a place of the mesh, or no_slot if it is
     *   not active.
     * @param adopt makes a place active that is so elsewhere, if it belongs to
     *   this rank (or else does nothing); the slots of such follow the others.
     * @param values @p n_values numbers per active place, by slot; gets longer
     *   with the adopted ones.
     */
    template <class SlotOf, class Adopt>
    void
    find_and_sum(SlotOf             &&slot_of,
                 Adopt              &&adopt,
                 std::vector<double> &values,
                 const unsigned int   n_values)
    {
      if (is_serial())
        return;
      list_slots(slot_of);
      n_active = values.size() / n_values;
      exchange_active(values, n_values);
      for (const unsigned int place : active_elsewhere())
        adopt(place);
      list_slots(slot_of);
      sum_first(values, n_values);
    }

    /// Sums further values at the places found before.
    void
    sum(double *values, const unsigned int n_values);

    /// The same for some numbers per place.
    template <std::size_t n>
    void
    sum(std::vector<std::array<double, n>> &values)
    {
      sum(values.empty() ? nullptr : values[0].data(), n);
    }

    /// The same for numbers in lanes.
    template <std::size_t n>
    void
    sum(std::vector<std::array<Lanes, n>> &values)
    {
      static_assert(sizeof(values[0]) == n * Lanes::n * sizeof(double));
      sum(reinterpret_cast<double *>(values.data()), n * Lanes::n);
    }

    /// The same for a vector field.
    void
    sum(std::vector<dealii::Tensor<1, dim>> &field);

    /**
     * Completes values of places that are set by the rank that counts the place
     * and zero elsewhere: each rank then has those of all nodes of its own
     * cells.
     *
     * @param values @p n_values numbers per place of the mesh.
     */
    void
    spread(std::vector<double> &values, const unsigned int n_values);

    /// Whether this rank counts the place in sums over all: the first of those
    /// that share it does.
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
    /// The places in common with a neighbour. The message of a first sum begins
    /// with the active ones of the list, as bits; then come the values of
    /// these.
    struct Link
    {
      std::vector<unsigned int> slots;  ///< of the neighbour's list
      std::vector<unsigned int> common; ///< slots of places active on both
      std::vector<unsigned int> place;  ///< of the common ones in a message
      std::vector<double>       outgoing;
      std::vector<double>       incoming;
    };

    /// Stands for a common place without a value in the message.
    static constexpr unsigned int not_sent = static_cast<unsigned int>(-1);

    template <class SlotOf>
    void
    list_slots(SlotOf &&slot_of)
    {
      links.resize(partition.neighbors().size());
      for (unsigned int k = 0; k < links.size(); ++k)
        {
          const auto &list = places(k).places;
          links[k].slots.resize(list.size());
          for (unsigned int i = 0; i < list.size(); ++i)
            links[k].slots[i] = slot_of(list[i]);
        }
    }

    /// What is shared with a neighbour.
    const Places &
    places(const unsigned int neighbor) const
    {
      return partition.neighbors()[neighbor].*of_neighbor;
    }

    /// Whether the neighbour has sent a value for entry @p i of its list.
    bool
    has_come(const Link &link, const std::size_t i) const;

    void
    exchange_active(const std::vector<double> &values,
                    const unsigned int         n_values);
    std::vector<unsigned int>
    active_elsewhere() const;
    void
    sum_first(std::vector<double> &values, const unsigned int n_values);
    void
    exchange_messages();
    void
    add_up(double *values, const unsigned int n_values);

    const Mesh::Partition<dim> &partition;
    const Places Neighbor::*const of_neighbor;
    unsigned int                  n_active = 0;
    std::vector<Link>             links;    ///< by neighbour
    std::vector<unsigned int>     shared;   ///< slots in any link
    std::vector<char>             is_first; ///< by slot
    std::vector<double>           totals;   ///< by slot
    std::vector<double>           packed;   ///< a vector field, by slot
    Traffic                       sent;
  };
} // namespace mpm_granular::Grid

#endif
