#include <deal.II/base/bounding_box.h>
#include <deal.II/base/utilities.h>

#include <mpm_granular/mesh/cell_order.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <tuple>

namespace mpm_granular::Mesh
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Cells =
      std::vector<typename Triangulation<dim>::active_cell_iterator>;
  }

  template <int dim>
  Cells<dim>
  hilbert_order(const Triangulation<dim> &triangulation)
  {
    std::vector<typename Triangulation<dim>::cell_iterator> given;
    std::vector<Point<dim>>                                 places;
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      {
        given.push_back(cell);
        places.push_back(cell->center());
      }

    // deal.II stretches the box around the places to a cube. A corner that
    // makes it one keeps near what is near, also in a slice or a channel.
    const BoundingBox<dim> box(places);
    Point<dim>             corner  = box.get_boundary_points().first;
    double                 longest = 0.;
    for (unsigned int d = 0; d < dim; ++d)
      longest = std::max(longest, box.side_length(d));
    for (unsigned int d = 0; d < dim; ++d)
      corner[d] += longest;
    places.push_back(corner);

    const int  bits = 64 / dim;
    const auto keys =
      Utilities::inverse_Hilbert_space_filling_curve(places, bits);

    std::vector<unsigned int> order(given.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(),
                     order.end(),
                     [&](const unsigned int a, const unsigned int b) {
                       return keys[a] < keys[b];
                     });
    Cells<dim>                                                            cells;
    const std::function<void(typename Triangulation<dim>::cell_iterator)> add =
      [&](const auto &cell) {
        if (cell->is_active())
          cells.push_back(cell);
        for (unsigned int c = 0; c < cell->n_children(); ++c)
          add(cell->child(c));
      };
    for (const unsigned int index : order)
      add(given[index]);
    return cells;
  }

  template <int dim>
  Cells<dim>
  morton_order(const parallel::distributed::Triangulation<dim> &triangulation)
  {
    using Path = std::vector<std::uint8_t>; // child after child
    std::vector<std::tuple<bool,
                           types::global_dof_index,
                           Path,
                           typename Cells<dim>::value_type>>
      keys;
    for (const auto &cell : triangulation.active_cell_iterators())
      if (!cell->is_artificial())
        {
          const CellId id   = cell->id();
          const auto   path = id.get_child_indices();
          keys.emplace_back(cell->is_ghost(),
                            id.get_coarse_cell_id(), // the tree
                            Path(path.begin(), path.end()),
                            cell);
        }
    std::sort(keys.begin(), keys.end(), [](const auto &a, const auto &b) {
      return std::tie(std::get<0>(a), std::get<1>(a), std::get<2>(a)) <
             std::tie(std::get<0>(b), std::get<1>(b), std::get<2>(b));
    });
    Cells<dim> cells;
    for (const auto &key : keys)
      cells.push_back(std::get<3>(key));
    return cells;
  }

  template Cells<2>
  hilbert_order(const Triangulation<2> &);
  template Cells<3>
  hilbert_order(const Triangulation<3> &);
  template Cells<2>
  morton_order(const parallel::distributed::Triangulation<2> &);
  template Cells<3>
  morton_order(const parallel::distributed::Triangulation<3> &);
} // namespace mpm_granular::Mesh
