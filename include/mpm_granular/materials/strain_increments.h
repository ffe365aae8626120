#ifndef mpm_granular_materials_strain_increments_h
#define mpm_granular_materials_strain_increments_h

#include <deal.II/base/array_view.h>
#include <deal.II/base/tensor.h>

#include <mpm_granular/materials/deviator.h>
#include <mpm_granular/points/point_arrays.h>

#include <array>
#include <cstdint>

namespace mpm_granular::Materials
{
  /**
   * What a time step does to some consecutive points, as the laws need it, as a
   * structure of arrays: entry i belongs to the i-th of the points. So a law is
   * a plain loop over points and knows nothing of cells. There is room for
   * @ref capacity points, few enough that these arrays stay in the first-level
   * cache.
   *
   * The stress is rotated at the middle of the step (T18). With the rotation of
   * half a step Q, s_tr = Q (Q s Q^T + 2 G dt e) Q^T = R s R^T + 2 G Q dt e
   * Q^T, where R = Q^2: the strain is rotated once for all points of a cell, so
   * that a law turns each stress once.
   */
  template <int dim>
  struct StrainIncrements
  {
    static constexpr unsigned int capacity = 64;

    /// Whole groups of so many are computed and written.
    static constexpr unsigned int vector = 8;
    static_assert(capacity % vector == 0);

    /// With room for what whole groups write behind the last entry.
    using Column = std::array<double, capacity + vector>;

    /// Components R_ij of the rotation of the step, row by row.
    alignas(64) std::array<Column, dim * dim> rotation;

    /// Deviator of dt sym(L), rotated to the end of the step: Q dt e Q^T, in
    /// the order of n_stress, tensor shears [-].
    alignas(64) std::array<Column, n_stress<dim>> deviatoric_strain;

    /// det(I + dt L), ratio of new to old volume (T17) [-].
    alignas(64) Column volume_ratio;

    /// ln det(I + dt L) (T19) [-]; no number where the volume is inverted.
    alignas(64) Column log_volume_ratio;

    double time_step; ///< [s]

    /**
     * Sets entry r to what @p velocity_gradients[r] does in a step.
     *
     * Q is the rotation of half a step by Cayley's form
     * @cite hughes_winget1980, (I - dt W/4)^-1 (I + dt W/4): rational, and
     * orthogonal to round-off for steps of any size.
     *
     * @param velocity_gradients L_ij = dv_i/dx_j [1/s], at most @ref capacity.
     * @param time_step [s].
     */
    void
    compute(
      const dealii::ArrayView<const dealii::Tensor<2, dim>> velocity_gradients,
      const double                                          time_step);

    /**
     * Sets the entries of the points of each run to the one of the run.
     *
     * @param of_runs entries by run.
     * @param run_of of each point the run: 0 for the first point, and then that
     *   of the point before or the next. At most @ref capacity points; numbers
     *   behind the last, up to a whole group of Selection, are read, too.
     */
    void
    spread(const StrainIncrements                      &of_runs,
           const dealii::ArrayView<const std::uint32_t> run_of);

    /// The rotation of point @p index.
    Rotation<dim>
    rotation_of(const unsigned int index) const
    {
      Rotation<dim> result;
      for (unsigned int c = 0; c < result.size(); ++c)
        result[c] = rotation[c][index];
      return result;
    }

    /// dt e : @p deviator of point @p index, with the rotated strain [Pa].
    double
    strain_product(const Stress<dim> &deviator, const unsigned int index) const
    {
      double product = 0.;
      for (unsigned int c = 0; c < n_stress<dim>; ++c)
        product += (stress_index[c][0] == stress_index[c][1] ? 1. : 2.) *
                   deviatoric_strain[c][index] * deviator[c];
      return product;
    }

    /// The trial deviator of point @p index (T18) [Pa].
    /// @param deviator before the step [Pa].
    Stress<dim>
    trial_deviator(const Stress<dim> &deviator,
                   const double       shear_modulus,
                   const unsigned int index) const
    {
      Stress<dim> trial = rotated_deviator<dim>(deviator, rotation_of(index));
      for (unsigned int c = 0; c < trial.size(); ++c)
        trial[c] += 2. * shear_modulus * deviatoric_strain[c][index];
      return trial;
    }
  };
} // namespace mpm_granular::Materials

#endif
