#ifndef mpm_granular_parameters_name_distance_h
#define mpm_granular_parameters_name_distance_h

#include <string>
#include <vector>

namespace mpm_granular::Parameters
{
  /**
   * The name in @p names that @p typed is most probably meant to be: the one
   * with the fewest letters to insert, remove, replace or exchange with their
   * neighbour, case ignored. Empty if none is similar enough.
   */
  std::string
  nearest_name(const std::string &typed, const std::vector<std::string> &names);

  /// " Did you mean 'x'?" with nearest_name(), or an empty string.
  std::string
  did_you_mean(const std::string &typed, const std::vector<std::string> &names);

  /// 'a', 'b', 'c'.
  std::string
  quoted_list(const std::vector<std::string> &names);
} // namespace mpm_granular::Parameters

#endif
