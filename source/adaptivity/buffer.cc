#include <deal.II/base/mpi.h>

#include <mpm_granular/adaptivity/buffer.h>

#include <algorithm>
#include <limits>

namespace mpm_granular::Adaptivity
{
  using namespace dealii;

  namespace
  {
    using Numbers = std::vector<unsigned int>;

    constexpr unsigned int far_away = std::numeric_limits<unsigned int>::max();

    /**
     * How far it is from the nearest source to the near side of each cell, in
     * widths of the finest cell; 0 for the sources. Known if less than @p reach.
     *
     * @param widths of the cells.
     */
    template <int dim>
    Numbers
    distances(const State<dim>        &state,
              const std::vector<bool> &is_source,
              const Numbers           &widths,
              const unsigned int       reach)
    {
      const auto &mesh = state.mesh;
      Numbers     near(mesh.n_cells(), far_away);
      // Most sources are among others and have nothing to tell.
      std::vector<bool> is_at_edge(mesh.n_nodes(), false);
      for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
        if (!is_source[cell])
          for (const unsigned int node : mesh.nodes(cell))
            is_at_edge[node] = true;
      Numbers front; // cells from which others may be nearer than known
      for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
        if (is_source[cell])
          {
            near[cell]       = 0;
            const auto nodes = mesh.nodes(cell);
            if (state.touching.has_others_beyond_faces(cell) ||
                std::any_of(nodes.begin(),
                            nodes.end(),
                            [&](const unsigned int node) {
                              return is_at_edge[node];
                            }))
              front.push_back(cell);
          }

      const auto goes_on = [&](const Numbers &list) {
        return Utilities::MPI::max(list.empty() ? 0 : 1,
                                   state.partition.communicator) == 1;
      };
      while (goes_on(front))
        {
          Numbers next;
          for (const unsigned int cell : front)
            {
              const unsigned int far_side =
                is_source[cell] ? 0 : near[cell] + widths[cell];
              if (far_side < reach)
                state.touching.for_each(cell, [&](const unsigned int other) {
                  if (other < mesh.n_own_cells() && far_side < near[other])
                    {
                      near[other] = far_side;
                      next.push_back(other);
                    }
                });
            }
          const Numbers before = near;
          state.send_to_ghosts(near);
          for (unsigned int ghost = mesh.n_own_cells(); ghost < mesh.n_cells();
               ++ghost)
            if (near[ghost] < before[ghost])
              next.push_back(ghost);
          front.swap(next);
        }
      return near;
    }
  } // namespace

  template <int dim>
  std::vector<unsigned int>
  add_layers(const State<dim>                &state,
             const std::vector<unsigned int> &wanted,
             const unsigned int               n_layers)
  {
    const unsigned int n_cells = wanted.size();
    const auto         highest = [&](const auto &value_of) {
      unsigned int value = 0;
      for (unsigned int cell = 0; cell < n_cells; ++cell)
        value = std::max(value, value_of(cell));
      return Utilities::MPI::max(value, state.partition.communicator);
    };
    const unsigned int highest_wanted =
      highest([&](const unsigned int cell) { return wanted[cell]; });
    const unsigned int finest =
      std::max(highest_wanted, highest([&](const unsigned int cell) {
                 return state.level(cell);
               }));

    Numbers           widths(n_cells);
    std::vector<bool> is_source(n_cells);
    for (unsigned int cell = 0; cell < n_cells; ++cell)
      widths[cell] = 1u << (finest - state.level(cell));

    Numbers result = wanted;
    for (unsigned int level = 1; level <= highest_wanted; ++level)
      {
        for (unsigned int cell = 0; cell < n_cells; ++cell)
          is_source[cell] = wanted[cell] >= level;
        const unsigned int reach = n_layers << (finest - level);
        const auto         near  = distances(state, is_source, widths, reach);
        for (unsigned int cell = 0; cell < n_cells; ++cell)
          if (near[cell] < reach)
            result[cell] = std::max(result[cell], level);
      }
    return result;
  }

  template std::vector<unsigned int>
  add_layers(const State<2> &,
             const std::vector<unsigned int> &,
             const unsigned int);
  template std::vector<unsigned int>
  add_layers(const State<3> &,
             const std::vector<unsigned int> &,
             const unsigned int);
} // namespace mpm_granular::Adaptivity
