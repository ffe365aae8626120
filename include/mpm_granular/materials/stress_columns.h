#ifndef mpm_granular_materials_stress_columns_h
#define mpm_granular_materials_stress_columns_h

#include <mpm_granular/points/point_arrays.h>

namespace mpm_granular::Materials
{
  /// The stresses of consecutive points, read and written point by point in
  /// loops that are to be vectorized.
  template <int dim>
  class StressColumns
  {
  public:
    /// @param begin the first of the points, which has index 0 here.
    StressColumns(Points::PointArrays<dim> &points, const unsigned int begin)
    {
      for (unsigned int c = 0; c < n_stress<dim>; ++c)
        component[c] = points.stress[c].data() + begin;
    }

    Stress<dim>
    load(const unsigned int index) const
    {
      Stress<dim> stress;
      for (unsigned int c = 0; c < n_stress<dim>; ++c)
        stress[c] = component[c][index];
      return stress;
    }

    /// Writes s - p I.
    void
    store(const unsigned int index,
          const Stress<dim> &deviator,
          const double       pressure)
    {
      for (unsigned int c = 0; c < n_stress<dim>; ++c)
        component[c][index] = deviator[c] - (c < 3 ? pressure : 0.);
    }

  private:
    std::array<double *, n_stress<dim>> component;
  };
} // namespace mpm_granular::Materials

#endif
