#ifndef mpm_granular_materials_merging_h
#define mpm_granular_materials_merging_h

#include <mpm_granular/materials/constitutive_law.h>

#include <cstddef>
#include <vector>

namespace mpm_granular::Materials
{
  /// What merging took out of the points of a rank.
  struct MergingLoss
  {
    std::size_t n_points = 0;  ///< how many there are less
    double      kinetic  = 0.; ///< energy, not negative [J, in 2D J/m]
    double      elastic  = 0.; ///< energy, not negative [J, in 2D J/m]
  };

  /**
   * Makes one of two points where a cell has more points than a number, until
   * it has so many: those of a material that are nearest to each other (T84).
   * Mass, momentum, centre of mass, volume and the sum of volume times stress
   * stay; energy and angular momentum do not. The point keeps the smaller id of
   * the two. All points must be in their cells.
   *
   * @param laws by material.
   */
  template <int dim>
  MergingLoss
  merge(Points::PointArrays<dim>                        &points,
        const std::vector<const ConstitutiveLaw<dim> *> &laws,
        const unsigned int                               most_per_cell);
} // namespace mpm_granular::Materials

#endif
