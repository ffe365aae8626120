#include <deal.II/base/mpi.h>

#include <mpm_granular/adaptivity/adaptation.h>
#include <mpm_granular/adaptivity/buffer.h>

#include <algorithm>

namespace mpm_granular::Adaptivity
{
  using namespace dealii;

  template <int dim>
  bool
  Adaptation<dim>::is_due(const unsigned int n_steps,
                          const double       displacement) const
  {
    return is_active() &&
           ((parameters.interval > 0 && n_steps >= parameters.interval) ||
            (parameters.interval_displacement > 0. &&
             displacement >= parameters.interval_displacement));
  }

  template <int dim>
  std::vector<std::uint8_t>
  Adaptation<dim>::wanted_levels(const State<dim> &state)
  {
    const auto wanted = ask_criteria(state);
    const auto fine   = add_layers(state, wanted, parameters.n_buffer_layers);
    // What a cell may keep is not less than what it is to have.
    auto levels =
      add_layers(state,
                 wanted,
                 parameters.n_buffer_layers + parameters.n_kept_layers);
    for (unsigned int cell = 0; cell < levels.size(); ++cell)
      levels[cell] =
        std::max(fine[cell], std::min(levels[cell], state.level(cell)));
    limit_number(state, levels);
    return {levels.begin(), levels.end()};
  }

  template <int dim>
  std::vector<unsigned int>
  Adaptation<dim>::ask_criteria(const State<dim> &state) const
  {
    const auto               &mesh = state.mesh;
    std::vector<unsigned int> wanted(mesh.n_cells(), parameters.minimum_level);
    for (const auto &name : parameters.criteria.all_names())
      {
        auto &criterion = *parameters.criteria[name].criterion;
        criterion.prepare(state);
        for (unsigned int cell = 0; cell < mesh.n_own_cells(); ++cell)
          if (state.partition.is_owned(cell))
            wanted[cell] =
              std::max(wanted[cell],
                       std::min(criterion.wanted_level(state, cell),
                                parameters.maximum_level));
      }
    if (mesh.is_distributed())
      state.send_to_ghosts(wanted);
    else
      Utilities::MPI::max(wanted, state.partition.communicator, wanted);
    return wanted;
  }

  template <int dim>
  void
  Adaptation<dim>::limit_number(const State<dim>          &state,
                                std::vector<unsigned int> &levels)
  {
    limited = false;
    if (parameters.maximum_n_cells == 0)
      return;

    // Cells to be divided, by their level; what coarsening frees counts when it
    // is free.
    const auto               &mesh = state.mesh;
    std::vector<unsigned int> n_divided(highest_level, 0);
    for (unsigned int cell = 0; cell < mesh.n_own_cells(); ++cell)
      if (state.level(cell) < levels[cell])
        ++n_divided[state.level(cell)];
    if (mesh.is_distributed())
      Utilities::MPI::sum(n_divided, mesh.mpi_communicator(), n_divided);

    std::uint64_t n_cells = mesh.n_global_cells();
    unsigned int  level   = 0;
    for (; level < highest_level; ++level)
      {
        n_cells += ((1u << dim) - 1) * std::uint64_t(n_divided[level]);
        if (n_divided[level] > 0 && n_cells > parameters.maximum_n_cells)
          break;
      }
    limited = level < highest_level;
    for (unsigned int cell = 0; cell < mesh.n_cells(); ++cell)
      if (state.level(cell) >= level)
        levels[cell] = std::min(levels[cell], state.level(cell));
  }

  template class Adaptation<2>;
  template class Adaptation<3>;
} // namespace mpm_granular::Adaptivity
