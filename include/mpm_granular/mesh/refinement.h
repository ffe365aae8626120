#ifndef mpm_granular_mesh_refinement_h
#define mpm_granular_mesh_refinement_h

#include <deal.II/distributed/tria.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/tria.h>

#include <cstdint>
#include <set>
#include <vector>

namespace mpm_granular::Mesh
{
  /**
   * Refines and coarsens a triangulation. The *level* of a cell counts from the
   * mesh as it was given. Cells with a common vertex differ by one level at
   * most.
   *
   * Hypercubes are left to p4est. deal.II cannot coarsen simplices: as the mesh
   * carries no state, the one that is wanted is then built from the given one
   * again.
   */
  template <int dim>
  class Refinement
  {
  public:
    using Triangulation = dealii::Triangulation<dim>;
    using Distributed   = dealii::parallel::distributed::Triangulation<dim>;
    using CellIterator  = typename Triangulation::active_cell_iterator;

    /// @param triangulation the mesh as given; must live as long.
    explicit Refinement(Triangulation &triangulation);

    unsigned int
    level(const CellIterator &cell) const
    {
      return cell->level() - given_level;
    }

    /// Whether any cell is refined, on any rank.
    bool
    is_refined() const
    {
      return triangulation.n_global_levels() > given_level + 1;
    }

    /**
     * Refines the cells that are below their wanted level, and coarsens those
     * families that are above, each by one level. Collective for a distributed
     * triangulation, whose cells stay where they are.
     *
     * @param wanted_levels of all active cells, by their active_cell_index();
     *   only those of own cells count if distributed.
     * @return whether any cell, on any rank, has changed.
     */
    bool
    adapt(const std::vector<std::uint8_t> &wanted_levels);

    /// The levels (of deal.II) of all active cells, in the order in which one
    /// meets them walking down the trees of the coarsest cells: the whole
    /// refinement, the same on all ranks. Collective.
    std::vector<std::uint8_t>
    tree() const;

    /// Makes the mesh whose tree() is @p levels. Collective.
    void
    grow(const std::vector<std::uint8_t> &levels);

    std::size_t
    memory_consumption() const
    {
      return given.memory_consumption();
    }

  private:
    bool
    is_own(const CellIterator &cell) const
    {
      return p4est == nullptr || cell->is_locally_owned();
    }

    /// What levels (of deal.II) cells are to have after one adaptation.
    std::vector<int>
    target_levels(const std::vector<std::uint8_t> &wanted_levels) const;
    void
    send_to_ghosts(std::vector<int> &values) const;
    void
    adapt_simplices(const std::vector<int> &target);
    void
    adapt_hypercubes(const std::vector<int> &target);
    std::vector<std::uint8_t>
    own_tree() const;
    void
    build(const std::set<dealii::CellId> &refined);
    void
    keep_given();

    Triangulation &triangulation;
    Distributed   *p4est;       ///< the same, if distributed
    unsigned int   given_level; ///< deal.II's level of the given cells
    Triangulation  given;       ///< of simplices, once they are refined
  };
} // namespace mpm_granular::Mesh

#endif
