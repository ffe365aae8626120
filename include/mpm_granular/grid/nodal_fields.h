#ifndef mpm_granular_grid_nodal_fields_h
#define mpm_granular_grid_nodal_fields_h

#include <deal.II/base/tensor.h>

#include <mpm_granular/core/archive.h>
#include <mpm_granular/core/fetch.h>
#include <mpm_granular/core/lanes.h>
#include <mpm_granular/grid/cell_sums.h>
#include <mpm_granular/grid/hanging_slots.h>
#include <mpm_granular/grid/node_sums.h>
#include <mpm_granular/grid/shared_sums.h>
#include <mpm_granular/grid/spread_sums.h>
#include <mpm_granular/mesh/background_mesh.h>

#include <utility>
#include <variant>
#include <vector>

namespace mpm_granular::Grid
{
  /// What the points receive from a node, side by side because it is read
  /// together.
  template <int dim>
  struct NodeMotion
  {
    dealii::Tensor<1, dim> velocity;  ///< after the step, moves points (T13)
    dealii::Tensor<1, dim> change;    ///< added to the points' velocity (T14)
    dealii::Tensor<1, dim> straining; ///< whose gradient strains points (T15)
    double unused = 0.; ///< so that four numbers can be read from the last
  };

  template <int dim>
  void
  add_scaled(NodeSums<dim>       &sum,
             const double         factor,
             const NodeSums<dim> &value)
  {
    sum.mass += factor * value.mass;
    sum.momentum += factor * value.momentum;
    sum.force += factor * value.force;
    sum.load += factor * value.load;
  }

  template <int dim>
  void
  add_scaled(NodeMotion<dim>       &sum,
             const double           factor,
             const NodeMotion<dim> &value)
  {
    sum.velocity += factor * value.velocity;
    sum.change += factor * value.change;
    sum.straining += factor * value.straining;
  }

  /// The active cells, by slot.
  template <class Cell>
  struct ActiveCells
  {
    std::vector<CellSums<Cell>> sums;

    /// Slots of the nodes.
    std::vector<std::array<unsigned int, Cell::n_nodes>> nodes;
  };

  /**
   * The fields of the grid on *active* cells and nodes only: cells that hold
   * points, and their nodes. Both are stored compactly, in the order in which
   * points meet them; a domain with more empty cells costs nothing here. Nodes
   * of other cells are active if shape functions reach them (SpreadSums).
   *
   * On several MPI ranks, each has the cells and nodes around its own points.
   * Cells keep the contributions of these points; nodes get the sums over all
   * ranks, so the member functions that sum over ranks are collective. The
   * nodes of the cells that a rank owns are active there if they are on any
   * rank.
   *
   * "Slot" is the place of a cell or node in the compact arrays. Active nodes
   * are free; vertices of active cells at hanging nodes have slots behind them
   * (HangingSlots).
   */
  template <int dim>
  class NodalFields
  {
  public:
    NodalFields(const Mesh::BackgroundMesh<dim> &mesh,
                const Mesh::Partition<dim>      &partition);

    /// Forgets all, for a mesh with new cells.
    void
    reinit();

    /// Forgets all active cells and their sums; nodes stay until
    /// gather_nodes().
    void
    clear_cells()
    {
      for (const unsigned int cell : active_cells)
        cell_slot[cell] = no_slot;
      active_cells.clear();
      visit([](auto &cells) { cells.sums.clear(); });
      spread.clear();
    }

    /// Calls @p action with the ActiveCells of the mesh's kind of cells.
    template <class Action>
    decltype(auto)
    visit(Action &&action)
    {
      return std::visit(std::forward<Action>(action), all_cells);
    }

    /// The active cells, if they are of the kind @p Cell.
    template <class Cell>
    ActiveCells<Cell> &
    cells()
    {
      return std::get<ActiveCells<Cell>>(all_cells);
    }

    template <class Cell>
    const ActiveCells<Cell> &
    cells() const
    {
      return std::get<ActiveCells<Cell>>(all_cells);
    }

    /// The sums of a cell, which becomes active (with zero sums) if it was not.
    /// @param cells those of this object.
    template <class Cell>
    CellSums<Cell> &
    sums_of(ActiveCells<Cell> &cells, const unsigned int cell)
    {
      const unsigned int slot = cell_slot[cell];
      if (slot != no_slot)
        return cells.sums[slot];
      cell_slot[cell] = active_cells.size();
      active_cells.push_back(cell);
      cells.sums.emplace_back();
      auto &sums = cells.sums.back();
      fetch<true>(&sums + n_cells_ahead);
      return sums;
    }

    /// Makes a cell active, if it is not.
    void
    activate(const unsigned int cell)
    {
      visit([&](auto &cells) { sums_of(cells, cell); });
    }

    /// Makes a cell active, with zero sums, after gather_nodes() has made all
    /// of its nodes active.
    void
    activate_late(const unsigned int cell);

    bool
    is_active_cell(const unsigned int cell) const
    {
      return cell_slot[cell] != no_slot;
    }

    /// Sets the sums of all stresses to zero.
    void
    clear_stresses()
    {
      spread.clear_forces();
      visit([](auto &cells) {
        for (auto &sums : cells.sums)
          sums.internal = {};
      });
    }

    /// Makes the nodes of the active cells the active nodes and sums their
    /// mass, momentum and internal force (T9) over all ranks: from the cells,
    /// and what points have given to nodes directly.
    /// @param with_forces false if gather_forces() follows.
    void
    gather_nodes(const bool with_forces = true);

    /**
     * Finds the active cells that several ranks have points in, and sums values
     * over the ranks. Cells that this rank owns become active if others have
     * points in them. After gather_nodes().
     *
     * @param values @p n_values numbers per active cell, by slot; gets longer
     *   with the cells that become active.
     */
    void
    find_shared_cells(std::vector<double> &values, const unsigned int n_values);

    /// Sets the internal forces of the nodes from the stresses of the cells of
    /// all ranks: for stresses that are known only after the masses.
    void
    gather_forces();

    /**
     * Adds (sampled consistent mass matrix) . @p field to @p result (T16), over
     * all ranks.
     *
     * @param field one vector per active node, by slot.
     */
    void
    add_mass_times(const std::vector<dealii::Tensor<1, dim>> &field,
                   std::vector<dealii::Tensor<1, dim>>       &result);

    /// What points have given to nodes directly, not by their cells.
    SpreadSums<dim> spread;

    /// Slots of vertices at hanging nodes.
    HangingSlots hanging;

    /// Sets the motion at hanging nodes from that of the active ones (T60).
    void
    extend_motion()
    {
      hanging.extend(motion);
    }

    /// Sums over the ranks at the active nodes.
    SharedSums<dim> shared;

    /// Sums over the ranks in the active cells, which are those of
    /// find_shared_cells().
    SharedSums<dim> shared_cells;

    /// What this rank has sent for sums at nodes and in cells so far.
    typename SharedSums<dim>::Traffic
    traffic() const
    {
      auto sent = shared.traffic();
      sent.n_messages += shared_cells.traffic().n_messages;
      sent.n_bytes += shared_cells.traffic().n_bytes;
      return sent;
    }

    unsigned int
    n_active_nodes() const
    {
      return active_nodes.size();
    }

    bool
    is_active_node(const unsigned int node) const
    {
      return node_slot[node] < active_nodes.size();
    }

    /// Slot of an active cell.
    unsigned int
    slot_of_cell(const unsigned int cell) const
    {
      return cell_slot[cell];
    }

    /// Whether a field of the active nodes has a value at this node.
    bool
    is_known_node(const unsigned int node) const;

    /// Slot of an active node, or of a hanging one that active cells have.
    unsigned int
    slot_of(const unsigned int node) const
    {
      return node_slot[node];
    }

    std::vector<unsigned int>    active_cells; ///< flat cell by slot
    std::vector<unsigned int>    active_nodes; ///< node by slot
    std::vector<NodeSums<dim>>   sums;         ///< by node slot
    std::vector<NodeMotion<dim>> motion; ///< by node slot, hanging ones too

    /// The sums of the cells, for checkpoints: summed again from the points
    /// they would differ by round-off.
    void
    serialize(Core::Archive &archive);

    std::size_t
    memory_consumption() const;

  private:
    /// Slot of what is not active.
    static constexpr unsigned int no_slot = SharedSums<dim>::no_slot;

    /// How many cells ahead of their use sums and geometry are asked for: 4 ns
    /// of 56 a point-step with a million points, nothing with 8,000.
    static constexpr unsigned int n_cells_ahead = 32;

    /// Asks for what gather_nodes() will need of a cell that is so far ahead.
    template <class Cell>
    void
    fetch_ahead(const std::vector<Cell>           &mesh_cells,
                const std::vector<CellSums<Cell>> &cell_sums,
                const unsigned int                 slot) const
    {
      const unsigned int ahead = slot + n_cells_ahead;
      if (ahead < active_cells.size())
        {
          fetch(&mesh_cells[active_cells[ahead]]);
          fetch(&cell_sums[ahead]);
        }
    }

    /// Completes what gather_nodes() has summed over the ranks.
    void
    sum_nodes();

    /// Makes a node active, if it is not.
    /// @return its slot.
    unsigned int
    activate_node(const unsigned int node)
    {
      unsigned int &slot = node_slot[node];
      if (slot == no_slot)
        {
          slot = active_nodes.size();
          active_nodes.push_back(node);
          sums.emplace_back();
        }
      return slot;
    }

    void
    gather_at_hanging(const std::vector<unsigned int> &slots,
                      const bool                       with_forces);
    void
    find_slots_of_vertices(const unsigned int slot);

    std::variant<ActiveCells<Mesh::SimplexCell<dim>>,
                 ActiveCells<Mesh::BoxCell<dim>>>
      all_cells;

    const Mesh::BackgroundMesh<dim> &mesh;
    const Mesh::Partition<dim>      &partition;
    std::vector<unsigned int>        cell_slot;     ///< by flat cell
    std::vector<unsigned int>        node_slot;     ///< by node
    std::vector<unsigned int>        hanging_nodes; ///< by slot behind others
    std::vector<double>              packed; ///< of nodes, for sums over ranks
    std::vector<dealii::Tensor<1, dim>> partial; ///< this rank's part of a sum

    /// For add_mass_times(): a field and its product, a cache line for each
    /// node, hanging ones too.
    struct Product
    {
      Lanes value, product;
    };
    std::vector<Product> products;
  };
} // namespace mpm_granular::Grid

#endif
