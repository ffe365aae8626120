#ifndef mpm_granular_materials_deviator_h
#define mpm_granular_materials_deviator_h

#include <mpm_granular/core/stress_layout.h>

#include <algorithm>
#include <array>
#include <cmath>

/*
 * Invariants and rotation of the stress of one point (T2, T18). The functions
 * are inline and have loops over components only, so that a loop over points
 * that calls them is vectorized.
 */
namespace mpm_granular::Materials
{
  /// Components R_ij of a rotation, row by row.
  template <int dim>
  using Rotation = std::array<double, dim * dim>;

  /// p = -tr(sigma)/3, positive in compression (T2) [Pa].
  template <typename StressType>
  inline double
  pressure(const StressType &stress)
  {
    return -(1. / 3.) * (stress[0] + stress[1] + stress[2]);
  }

  /// s = sigma + p I (T2) [Pa].
  template <typename StressType>
  inline StressType
  deviator(StressType stress)
  {
    const double p = pressure(stress);
    for (unsigned int c = 0; c < 3; ++c)
      stress[c] += p;
    return stress;
  }

  /// q^2 = 3/2 s:s of a tensor s without trace (T2) [Pa^2].
  template <typename StressType>
  inline double
  equivalent_stress_square(const StressType &tensor)
  {
    double normal = 0., shear = 0.;
    for (unsigned int c = 0; c < 3; ++c)
      normal += tensor[c] * tensor[c];
    for (unsigned int c = 3; c < tensor.size(); ++c)
      shear += tensor[c] * tensor[c];
    return 1.5 * normal + 3. * shear;
  }

  /// Equivalent stress q of a stress, not only of a deviator (T2) [Pa].
  template <typename StressType>
  inline double
  equivalent_stress(const StressType &stress)
  {
    return std::sqrt(equivalent_stress_square(deviator(stress)));
  }

  /**
   * R s R^T of a tensor without trace, whose zz follows from xx and yy. In
   * plane strain R turns about z.
   */
  template <int dim>
  inline Stress<dim>
  rotated_deviator(const Stress<dim> &tensor, const Rotation<dim> &rotation)
  {
    constexpr unsigned int component[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};

    Rotation<dim> half; // R s
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        {
          half[i * dim + j] = 0.;
          for (unsigned int k = 0; k < dim; ++k)
            half[i * dim + j] +=
              rotation[i * dim + k] * tensor[component[k][j]];
        }

    Stress<dim> result;
    for (unsigned int c = 0; c < n_stress<dim>; ++c)
      if (c != 2)
        {
          const unsigned int i =
            std::min(stress_index[c][0], stress_index[c][1]);
          const unsigned int j =
            std::max(stress_index[c][0], stress_index[c][1]);
          result[c] = 0.;
          for (unsigned int k = 0; k < dim; ++k)
            result[c] += half[i * dim + k] * rotation[j * dim + k];
        }
    result[2] = -(result[0] + result[1]);
    return result;
  }
} // namespace mpm_granular::Materials

#endif
