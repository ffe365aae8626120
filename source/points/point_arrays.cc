#include <mpm_granular/points/point_arrays.h>

#include <type_traits>

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

  template <int dim>
  void
  PointArrays<dim>::keep(const std::vector<unsigned int> &list)
  {
    for_each_array([&](auto &array) {
      typename std::remove_reference<decltype(array)>::type kept(list.size());
      for (std::size_t p = 0; p < list.size(); ++p)
        kept[p] = array[list[p]];
      array.swap(kept);
    });
  }

  template struct PointArrays<2>;
  template struct PointArrays<3>;
} // namespace mpm_granular::Points
