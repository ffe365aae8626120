#include <mpm_granular/points/point_arrays.h>

namespace mpm_granular::Points
{
  template <int dim>
  void
  PointArrays<dim>::resize(const std::size_t  n_points,
                           const unsigned int n_history)
  {
    history.resize(n_history);
    for_each_array([&](auto &array) { array.resize(n_points); });
  }

  template struct PointArrays<2>;
  template struct PointArrays<3>;
} // namespace mpm_granular::Points
