#include <mpm_granular/points/point_arrays.h>

#include <tuple>
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
    // One array of each type goes from one to the next: large ones that are
    // allocated anew cost a page fault every 4 kB.
    std::tuple<Array, std::vector<unsigned int>, std::vector<std::uint8_t>>
      scratch;
    for_each_array([&](auto &array) {
      auto &kept = std::get<std::decay_t<decltype(array)>>(scratch);
      kept.resize(list.size());
      for (std::size_t p = 0; p < list.size(); ++p)
        kept[p] = array[list[p]];
      array.swap(kept);
    });
  }

  template <int dim>
  std::vector<std::string>
  PointArrays<dim>::array_names(const std::vector<std::string> &history_names)
  {
    std::vector<std::string> names;
    for (const std::string vector : {"position_", "velocity_"})
      for (unsigned int d = 0; d < dim; ++d)
        names.push_back(vector + "xyz"[d]);
    for (unsigned int s = 0; s < n_stress<dim>; ++s)
      names.push_back(std::string("stress_") + stress_name[s]);
    names.insert(names.end(), {"mass", "volume"});
    for (unsigned int slot = 0; slot < history_names.size(); ++slot)
      names.push_back("history_" + std::to_string(slot) + "_" +
                      history_names[slot]);
    names.insert(names.end(), {"cell", "id", "material"});
    return names;
  }

  template struct PointArrays<2>;
  template struct PointArrays<3>;
} // namespace mpm_granular::Points
