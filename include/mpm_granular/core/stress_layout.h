#ifndef mpm_granular_core_stress_layout_h
#define mpm_granular_core_stress_layout_h

#include <array>

namespace mpm_granular
{
  /**
   * Number of stored stress components: xx, yy, zz, xy in plane strain (dim =
   * 2, the out-of-plane stress zz is part of the state), and xx, yy, zz, xy,
   * yz, zx in space (dim = 3). Shear components are tensor components.
   */
  template <int dim>
  inline constexpr unsigned int n_stress = dim == 2 ? 4 : 6;

  /// The stress components of one point, in the order of @ref n_stress.
  template <int dim>
  using Stress = std::array<double, n_stress<dim>>;

  /// Row and column of each stored component.
  inline constexpr unsigned int stress_index[6][2] =
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}};

  /// Names of the stored components, for output.
  inline constexpr const char *stress_name[6] =
    {"xx", "yy", "zz", "xy", "yz", "zx"};
} // namespace mpm_granular

#endif
