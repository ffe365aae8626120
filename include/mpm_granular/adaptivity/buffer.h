#ifndef mpm_granular_adaptivity_buffer_h
#define mpm_granular_adaptivity_buffer_h

#include <mpm_granular/adaptivity/state.h>

#include <vector>

namespace mpm_granular::Adaptivity
{
  /**
   * The levels that cells want if what a cell wants is also wanted within some
   * layers around it (T82). Layers are of cells of the level in question: a
   * coarser cell counts as the many layers that it would be divided into, so
   * that growth does not leap over coarse cells. Collective.
   *
   * @param wanted by cell, ghosts as well.
   * @return likewise.
   */
  template <int dim>
  std::vector<unsigned int>
  add_layers(const State<dim>                &state,
             const std::vector<unsigned int> &wanted,
             const unsigned int               n_layers);
} // namespace mpm_granular::Adaptivity

#endif
