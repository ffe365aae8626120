#include <mpm_granular/adaptivity/free_surface.h>
#include <mpm_granular/adaptivity/level_entry.h>

namespace mpm_granular::Adaptivity
{
  using namespace dealii;

  template <int dim>
  void
  FreeSurface<dim>::add_parameters(ParameterHandler &prm)
  {
    add_level_entry(prm, level, "Level of the cells of the surface");
  }

  template <int dim>
  unsigned int
  FreeSurface<dim>::wanted_level(const State<dim>  &state,
                                 const unsigned int cell) const
  {
    if (state.n_points(cell) == 0)
      return 0;
    bool touches_empty_cell = false;
    state.touching.for_each(cell, [&](const unsigned int other) {
      touches_empty_cell = touches_empty_cell || state.n_points(other) == 0;
    });
    return touches_empty_cell ? level : 0;
  }

  template class FreeSurface<2>;
  template class FreeSurface<3>;

  namespace
  {
    const std::string documentation =
      "cells with points that touch cells without.";
    const CriterionRegistry<2>::Entry<FreeSurface<2>>
      free_surface_2d("free surface", documentation);
    const CriterionRegistry<3>::Entry<FreeSurface<3>>
      free_surface_3d("free surface", documentation);
  } // namespace
} // namespace mpm_granular::Adaptivity
