#include <mpm_granular/transfer/settled_pressures.h>

#include <algorithm>
#include <cmath>

namespace mpm_granular::Transfer
{
  using namespace dealii;

  template <int dim>
  SettledPressures<dim>::SettledPressures(const Mesh::BackgroundMesh<dim> &mesh,
                                          const unsigned int first_slot,
                                          const bool         is_wanted)
    : mesh(mesh)
    , slot(first_slot)
    , is_wanted(is_wanted)
  {}

  template <int dim>
  std::vector<std::string>
  SettledPressures<dim>::history_names(const bool is_wanted)
  {
    return is_wanted ? std::vector<std::string>{"settled_pressure"} :
                       std::vector<std::string>{};
  }

  template <int dim>
  void
  SettledPressures<dim>::keep(Points::PointArrays<dim> &points,
                              const PointBlock<dim>    &block,
                              const Array              &smooth_pressure) const
  {
    if (!is_wanted)
      return;
    auto &difference = points.history[slot];
    for (unsigned int p = block.begin; p < block.end; ++p)
      {
        const double pressure = points.pressure(p);
        difference[p] =
          pressure > 0. ? pressure - smooth_pressure[p - block.begin] : 0.;
      }
  }

  template <int dim>
  void
  SettledPressures<dim>::add(Points::PointArrays<dim> &points,
                             const PointBlock<dim>    &block,
                             const double              time,
                             Array                    &smooth_pressure) const
  {
    if (!is_wanted)
      return;
    // In the next cell, half a cell away on average, points mean other sums.
    constexpr double part       = 0.5;
    auto            &difference = points.history[slot];
    for (const auto &run : block.runs)
      {
        const double reach =
          part * mesh.size_of_cell(mesh.cell_volume(points.cell[run.begin]));
        for (unsigned int p = run.begin; p < run.end; ++p)
          {
            double speed_squared = 0.;
            for (unsigned int d = 0; d < dim; ++d)
              speed_squared += points.velocity[d][p] * points.velocity[d][p];
            difference[p] *=
              std::max(0., 1. - std::sqrt(speed_squared) * time / reach);
            double &smooth = smooth_pressure[p - block.begin];
            smooth         = std::max(0., smooth + difference[p]);
          }
      }
  }

  template class SettledPressures<2>;
  template class SettledPressures<3>;
} // namespace mpm_granular::Transfer
