#ifndef mpm_granular_drive_loading_h
#define mpm_granular_drive_loading_h

#include <deal.II/base/tensor.h>

#include <mpm_granular/core/stress_layout.h>

#include <string>

namespace mpm_granular::Drive
{
  /**
   * How a test strains a point: its velocity gradient is
   * rate (driven + x adjusted), where x is found in every step so that
   * something stays as it is.
   */
  struct Loading
  {
    enum class Keeps
    {
      nothing, ///< all strains are given
      stress,  ///< a component of the stress
      volume
    };

    dealii::Tensor<2, 3> driven;
    dealii::Tensor<2, 3> adjusted;
    Keeps                keeps     = Keeps::nothing;
    unsigned int         component = 0; ///< in the order of n_stress

    /// A deviator in the direction of the test, for the yield line.
    Stress<3> deviator{};
  };

  /// Names of the tests, separated by '|'.
  std::string
  test_names();

  /// What each test does, for the documentation.
  std::string
  test_documentation();

  /// @param test one of test_names().
  Loading
  loading_of(const std::string &test);
} // namespace mpm_granular::Drive

#endif
