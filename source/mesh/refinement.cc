#include <deal.II/base/mpi.h>
#include <deal.II/grid/grid_tools.h>

#include <boost/serialization/vector.hpp>

#include <mpm_granular/mesh/refinement.h>

#include <algorithm>
#include <functional>

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
    const std::vector<int> target = target_levels(wanted_levels);

    bool has_changed = false;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (is_own(cell) && target[cell->active_cell_index()] != cell->level())
        has_changed = true;
    if (p4est != nullptr)
      has_changed =
        Utilities::MPI::logical_or(has_changed, p4est->get_communicator());
    if (!has_changed)
      return false;
    if (p4est != nullptr)
      adapt_hypercubes(target);
    else
      adapt_simplices(target);
    return true;
  }

  template <int dim>
  std::vector<int>
  Refinement<dim>::target_levels(
    const std::vector<std::uint8_t> &wanted_levels) const
  {
    std::vector<int> target(wanted_levels.size());
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        const unsigned int index = cell->active_cell_index();
        target[index] = std::clamp<int>(given_level + wanted_levels[index],
                                        cell->level() - 1,
                                        cell->level() + 1);
      }

    // What p4est and deal.II would do to keep jumps small depends on who owns
    // what: leave nothing for them to do.
    const auto may_coarsen = [&](const Cell<dim> &cell) {
      return is_own(CellIterator(cell)) &&
             target[cell->active_cell_index()] < cell->level();
    };
    std::vector<int> highest(triangulation.n_vertices());
    for (bool is_changing = true; is_changing;)
      {
        is_changing = false;
        send_to_ghosts(target);
        std::fill(highest.begin(), highest.end(), 0);
        for (const auto &cell : triangulation.active_cell_iterators())
          if (!cell->is_artificial())
            for (const unsigned int v : cell->vertex_indices())
              {
                int &of_vertex = highest[cell->vertex_index(v)];
                of_vertex =
                  std::max(of_vertex, target[cell->active_cell_index()]);
              }
        for (const auto &cell : triangulation.active_cell_iterators())
          if (is_own(cell))
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
        if (p4est != nullptr)
          is_changing =
            Utilities::MPI::logical_or(is_changing, p4est->get_communicator());
      }
    return target;
  }

  template <int dim>
  void
  Refinement<dim>::send_to_ghosts(std::vector<int> &values) const
  {
    if (p4est == nullptr)
      return;
    GridTools::exchange_cell_data_to_ghosts<int, Triangulation>(
      triangulation,
      [&](const CellIterator &cell) {
        return values[cell->active_cell_index()];
      },
      [&](const CellIterator &cell, const int &value) {
        values[cell->active_cell_index()] = value;
      });
  }

  template <int dim>
  void
  Refinement<dim>::adapt_simplices(const std::vector<int> &target)
  {
    std::set<CellId> coarsened;
    for (const auto &cell : triangulation.active_cell_iterators())
      {
        if (target[cell->active_cell_index()] < cell->level())
          coarsened.insert(cell->parent()->id());
      }
    keep_given();
    if (coarsened.empty())
      {
        for (const auto &cell : triangulation.active_cell_iterators())
          if (target[cell->active_cell_index()] > cell->level())
            cell->set_refine_flag();
        triangulation.execute_coarsening_and_refinement();
        return;
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
  }

  template <int dim>
  void
  Refinement<dim>::adapt_hypercubes(const std::vector<int> &target)
  {
    // deal.II checks each rank's flags with what it sees around: let it see
    // those of ghosts, and of their families.
    for (const auto &cell : triangulation.active_cell_iterators())
      if (!cell->is_artificial())
        {
          const int of_cell = target[cell->active_cell_index()];
          if (of_cell > cell->level())
            cell->set_refine_flag();
          else if (of_cell < cell->level())
            for (unsigned int c = 0; c < cell->parent()->n_children(); ++c)
              if (cell->parent()->child(c)->is_active())
                cell->parent()->child(c)->set_coarsen_flag();
        }
    triangulation.execute_coarsening_and_refinement();
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
    for (types::coarse_cell_id root = 0; root < triangulation.n_cells(0);
         ++root)
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
    for (types::coarse_cell_id root = 0; root < triangulation.n_cells(0);
         ++root)
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
        is_changing =
          Utilities::MPI::logical_or(is_changing, p4est->get_communicator());
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
