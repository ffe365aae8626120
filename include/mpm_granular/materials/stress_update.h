#ifndef mpm_granular_materials_stress_update_h
#define mpm_granular_materials_stress_update_h

#include <deal.II/base/array_view.h>

#include <mpm_granular/materials/constitutive_law.h>

namespace mpm_granular::Materials
{
  /**
   * Advances volume (T17), stress and history of the points of some runs over a
   * step. The runs share the law and need not follow each other without gaps
   * (points of other laws may lie between), but it is fastest if they do.
   * Nothing is allocated; what the step does to a run is computed once.
   *
   * @param velocity_gradients L_ij = dv_i/dx_j of each run [1/s].
   * @param time_step [s].
   * @return elastic energy that the law took out of the points
   *   [J, in 2D J/m]; not a number if the state of a point is not.
   * @throws ComputationError if a volume would not stay positive. Points of
   *   earlier runs have been advanced then.
   */
  template <int dim>
  double
  update_stress(
    const ConstitutiveLaw<dim>                           &law,
    Points::PointArrays<dim>                             &points,
    const dealii::ArrayView<const Points::Run>            runs,
    const dealii::ArrayView<const dealii::Tensor<2, dim>> velocity_gradients,
    const double                                          time_step);
} // namespace mpm_granular::Materials

#endif
