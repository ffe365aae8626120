#include <mpm_granular/adaptivity/point_number.h>

#include <cstdint>

namespace mpm_granular::Adaptivity
{
  using namespace dealii;

  template <int dim>
  void
  PointNumber<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Largest number of points",
                      largest_number,
                      "A cell with more points is divided; the cells that one "
                      "cell was divided into become one again when none of "
                      "them has more than this over their number (4, in 3D 8). "
                      "Units: none.",
                      Patterns::Integer(1));
  }

  template <int dim>
  unsigned int
  PointNumber<dim>::wanted_level(const State<dim>  &state,
                                 const unsigned int cell) const
  {
    const std::uint64_t n     = state.n_points(cell);
    unsigned int        level = state.level(cell);
    if (n > largest_number)
      for (std::uint64_t most = largest_number; n > most; most <<= dim)
        ++level;
    else
      for (std::uint64_t of_parent = n << dim;
           level > 0 && of_parent <= largest_number;
           of_parent <<= dim)
        --level;
    return level;
  }

  template class PointNumber<2>;
  template class PointNumber<3>;

  namespace
  {
    const std::string documentation =
      "cells with points, so fine that none has more than a number of points.";
    const CriterionRegistry<2>::Entry<PointNumber<2>> points_2d("points",
                                                                documentation);
    const CriterionRegistry<3>::Entry<PointNumber<3>> points_3d("points",
                                                                documentation);
  } // namespace
} // namespace mpm_granular::Adaptivity
