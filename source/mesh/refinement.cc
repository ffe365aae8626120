#include <deal.II/base/mpi.h>

#include <boost/serialization/vector.hpp>

#include <mpm_granular/mesh/refinement.h>

#include <algorithm>
#include <functional>
#include <numeric>

namespace mpm_granular::Mesh
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Cell = typename Triangulation<dim>::cell_iterator;

    /// Calls @p action with the cells that are refined.
    template <int dim, class Action>
    void
    for_each_refined(const Triangulation<dim> &triangulation, Action &&action)
    {
      for (const auto &cell : triangulation.cell_iterators())
        if (cell->has_children())
          action(cell);
    }

    /// Whether a cell is one of a family that lets @p may_go go.
    template <int dim, class MayGo>
    bool
    is_in_family_that(const Cell<dim> &cell, MayGo &&may_go)
    {
      if (cell->level() == 0)
        return false;
      const auto parent = cell->parent();
      for (unsigned int c = 0; c < parent->n_children(); ++c)
        if (!parent->child(c)->is_active() || !may_go(parent->child(c)))
          return false;
      return true;
    }

    /**
     * Sets what level the cells are to have after one adaptation: cells with a
     * common vertex differ by one at most.
     *
     * @param may_coarsen whether a cell may become coarser.
     */
    template <int dim>
    void
    limit_jumps(const Triangulation<dim>                         &triangulation,
                std::vector<int>                                 &target,
                const std::function<bool(const Cell<dim> &cell)> &may_coarsen)
    {
      std::vector<int> highest(triangulation.n_vertices());
      for (bool is_changing = true; is_changing;)
        {
          is_changing = false;
          std::fill(highest.begin(), highest.end(), 0);
          for (const auto &cell : triangulation.active_cell_iterators())
            for (const unsigned int v : cell->vertex_indices())
              {
                int &of_vertex = highest[cell->vertex_index(v)];
                of_vertex =
                  std::max(of_vertex, target[cell->active_cell_index()]);
              }
          for (const auto &cell : triangulation.active_cell_iterators())
            {
              int      &of_cell = target[cell->active_cell_index()];
              const int before  = of_cell;
              for (const unsigned int v : cell->vertex_indices())
                of_cell = std::max(of_cell, highest[cell->vertex_index(v)] - 1);
              if (of_cell < cell->level() &&
                  !is_in_family_that<dim>(cell, may_coarsen))
                of_cell = cell->level();
              is_changing = is_changing || of_cell != before;
            }
        }
    }
  } // namespace

  template <int dim>
  Refinement<dim>::Refinement(Triangulation &triangulation)
    : triangulation(triangulation)
    , p4est(dynamic_cast<Distributed *>(&triangulation))
    , given_level(triangulation.n_global_levels() - 1)
  {}

  template <int dim>
  bool
  Refinement<dim>::adapt(const std::vector<std::uint8_t> &wanted_levels)
  {
    AssertDimension(wanted_levels.size(), triangulation.n_active_cells());
    return p4est != nullptr ? adapt_hypercubes(wanted_levels) :
                              adapt_simplices(wanted_levels);
  }

  template <int dim>
  bool
  Refinement<dim>::adapt_simplices(
    const std::vector<std::uint8_t> &wanted_levels)
  {
    std::vector<int> target(wanted_levels.size());
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        const unsigned int index = cell->active_cell_index();
        target[index]            = std::clamp<int>(given_level +
                                          wanted_levels[index],
                                        cell->level() - 1,
                                        cell->level() + 1);
      }
    limit_jumps<dim>(triangulation, target, [&](const Cell<dim> &cell) {
      return target[cell->active_cell_index()] < cell->level();
    });

    bool             is_any_refined = false;
    std::set<CellId> coarsened;
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        const int of_cell = target[cell->active_cell_index()];
        is_any_refined    = is_any_refined || of_cell > cell->level();
        if (of_cell < cell->level())
          coarsened.insert(cell->parent()->id());
      }
    if (!is_any_refined && coarsened.empty())
      return false;

    keep_given();
    if (coarsened.empty())
      {
        for (const auto &cell : triangulation.active_cell_iterators())
          if (target[cell->active_cell_index()] > cell->level())
            cell->set_refine_flag();
        triangulation.execute_coarsening_and_refinement();
        return true;
      }
    std::set<CellId> refined;
    for_each_refined(triangulation, [&](const auto &cell) {
      if (coarsened.count(cell->id()) == 0)
        refined.insert(cell->id());
    });
    for (const auto &cell : triangulation.active_cell_iterators())
      if (target[cell->active_cell_index()] > cell->level())
        refined.insert(cell->id());
    build(refined);
    return true;
  }

  template <int dim>
  bool
  Refinement<dim>::adapt_hypercubes(
    const std::vector<std::uint8_t> &wanted_levels)
  {
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          const int wanted =
            given_level + wanted_levels[cell->active_cell_index()];
          if (wanted > cell->level())
            cell->set_refine_flag();
          else if (wanted < cell->level())
            cell->set_coarsen_flag();
        }
    const auto before = own_tree();
    triangulation.execute_coarsening_and_refinement();
    return Utilities::MPI::logical_or(own_tree() != before,
                                      p4est->get_communicator());
  }

  template <int dim>
  std::vector<types::coarse_cell_id>
  Refinement<dim>::roots() const
  {
    std::vector<types::coarse_cell_id> order(triangulation.n_cells(0));
    if (p4est == nullptr)
      std::iota(order.begin(), order.end(), 0);
    else
      std::copy(p4est->get_p4est_tree_to_coarse_cell_permutation().begin(),
                p4est->get_p4est_tree_to_coarse_cell_permutation().end(),
                order.begin());
    return order;
  }

  template <int dim>
  std::vector<std::uint8_t>
  Refinement<dim>::own_tree() const
  {
    std::vector<std::uint8_t>                    levels;
    const std::function<void(const Cell<dim> &)> walk_down =
      [&](const Cell<dim> &cell) {
        if (cell->has_children())
          for (unsigned int c = 0; c < cell->n_children(); ++c)
            walk_down(cell->child(c));
        else if (p4est == nullptr || cell->is_locally_owned())
          levels.push_back(cell->level());
      };
    for (const auto root : roots())
      walk_down(triangulation.create_cell_iterator(CellId(root, 0, nullptr)));
    return levels;
  }

  template <int dim>
  std::vector<std::uint8_t>
  Refinement<dim>::tree() const
  {
    if (p4est == nullptr)
      return own_tree();
    // Each rank has a piece of the curve that runs through all trees.
    std::vector<std::uint8_t> all;
    for (const auto &of_rank :
         Utilities::MPI::all_gather(p4est->get_communicator(), own_tree()))
      all.insert(all.end(), of_rank.begin(), of_rank.end());
    return all;
  }

  template <int dim>
  void
  Refinement<dim>::grow(const std::vector<std::uint8_t> &levels)
  {
    std::set<CellId>          refined;
    std::vector<std::uint8_t> path;
    std::size_t               next = 0;
    const auto                n_children =
      triangulation.begin()->reference_cell().template n_isotropic_children();
    const std::function<void(const types::coarse_cell_id)> walk_down =
      [&](const types::coarse_cell_id coarse) {
        AssertThrow(next < levels.size(), ExcInternalError());
        if (levels[next] == path.size())
          {
            ++next;
            return;
          }
        refined.insert(CellId(coarse, path));
        for (unsigned int c = 0; c < n_children; ++c)
          {
            path.push_back(c);
            walk_down(coarse);
            path.pop_back();
          }
      };
    for (const auto root : roots())
      walk_down(root);
    AssertThrow(next == levels.size(), ExcInternalError());

    if (p4est == nullptr)
      {
        keep_given();
        build(refined);
        return;
      }
    for (bool is_changing = true; is_changing;)
      {
        is_changing = false;
        for (const auto &cell : triangulation.active_cell_iterators())
          if (cell->is_locally_owned())
            {
              if (refined.count(cell->id()) > 0)
                cell->set_refine_flag();
              else if (cell->level() > 0 &&
                       refined.count(cell->parent()->id()) == 0)
                cell->set_coarsen_flag();
              else
                continue;
              is_changing = true;
            }
        is_changing = Utilities::MPI::logical_or(is_changing,
                                                 p4est->get_communicator());
        triangulation.execute_coarsening_and_refinement();
        p4est->repartition(); // keeps families together
      }
  }

  template <int dim>
  void
  Refinement<dim>::build(const std::set<CellId> &refined)
  {
    triangulation.clear();
    triangulation.copy_triangulation(given);
    for (bool is_changing = true; is_changing;)
      {
        is_changing = false;
        for (const auto &cell : triangulation.active_cell_iterators())
          if (refined.count(cell->id()) > 0)
            {
              cell->set_refine_flag();
              is_changing = true;
            }
        triangulation.execute_coarsening_and_refinement();
      }
  }

  template <int dim>
  void
  Refinement<dim>::keep_given()
  {
    if (given.n_levels() == 0)
      given.copy_triangulation(triangulation);
  }

  template class Refinement<2>;
  template class Refinement<3>;
} // namespace mpm_granular::Mesh
