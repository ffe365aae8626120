#include <deal.II/base/symmetric_tensor.h>

#include <mpm_granular/adaptivity/level_entry.h>
#include <mpm_granular/adaptivity/shear.h>
#include <mpm_granular/parameters/pattern_text.h>

#include <algorithm>
#include <cmath>

namespace mpm_granular::Adaptivity
{
  using namespace dealii;

  namespace
  {
    /// sqrt(2 d:d) of the deviator of the strain rate, in plane strain if in
    /// 2D [1/s].
    template <int dim>
    double
    shear_rate(const Tensor<2, dim> &velocity_gradient)
    {
      const SymmetricTensor<2, dim> rate   = symmetrize(velocity_gradient);
      const double                  volume = trace(rate);
      return std::sqrt(std::max(0., 2. * (rate * rate - volume * volume / 3.)));
    }
  } // namespace

  template <int dim>
  void
  Shear<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Largest jump",
                      largest_jump,
                      "A cell is divided if its shear rate times its size is "
                      "more than this part of the speed. Units: none.",
                      Parameters::positive_number());
    prm.add_parameter("Coarsening part",
                      coarsening_part,
                      "Cells may become coarser where that is less than this "
                      "part of the largest jump. Above 0.5 cells could be "
                      "divided and undone in turn. Units: none.",
                      Patterns::Double(0., 0.5));
    prm.add_parameter("Speed",
                      speed,
                      "What jumps are compared with; 0 stands for the largest "
                      "speed of the nodes at the time. A body that comes to "
                      "rest needs a given one, or its last small motion "
                      "counts as much as its fall. Units: m/s.",
                      Patterns::Double(0.));
    add_level_entry(prm, level, "Highest level that shear leads to");
  }

  template <int dim>
  void
  Shear<dim>::prepare(const State<dim> &state)
  {
    speed_in_use = speed > 0. ? speed : state.largest_speed();
  }

  template <int dim>
  unsigned int
  Shear<dim>::wanted_level(const State<dim>  &state,
                           const unsigned int cell) const
  {
    const double jump =
      shear_rate(state.velocity_gradient(cell)) * state.size(cell);
    const unsigned int present = state.level(cell);
    if (jump > largest_jump * speed_in_use)
      return std::min(present + 1, level);
    if (jump > coarsening_part * largest_jump * speed_in_use)
      return std::min(present, level);
    return present == 0 ? 0 : std::min(present - 1, level);
  }

  template class Shear<2>;
  template class Shear<3>;

  namespace
  {
    const std::string documentation =
      "cells in which the velocity changes much by shear.";
    const CriterionRegistry<2>::Entry<Shear<2>> shear_2d("shear",
                                                         documentation);
    const CriterionRegistry<3>::Entry<Shear<3>> shear_3d("shear",
                                                         documentation);
  } // namespace
} // namespace mpm_granular::Adaptivity
