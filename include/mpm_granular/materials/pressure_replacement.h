#ifndef mpm_granular_materials_pressure_replacement_h
#define mpm_granular_materials_pressure_replacement_h

#include <mpm_granular/materials/elastic_moduli.h>
#include <mpm_granular/points/point_arrays.h>

namespace mpm_granular::Materials
{
  /// Pressures below, and the deviators there, are round-off [Pa].
  inline double
  negligible_pressure(const ElasticModuli &moduli)
  {
    return 1e-12 * moduli.bulk();
  }

  /**
   * Replaces the pressures of those points of a run that are in contact by
   * given ones, at the same stress over strength (T29).
   *
   * @param target entry i belongs to point run.begin + i, 0 or more [Pa].
   * @param apex tension at which the strength ends, 0 or more [Pa].
   * @return elastic energy that this took out of the points [J, in 2D J/m].
   */
  template <int dim>
  double
  replace_pressure(Points::PointArrays<dim> &points,
                   const Points::Run         run,
                   const double             *target,
                   const double              apex,
                   const ElasticModuli      &moduli);
} // namespace mpm_granular::Materials

#endif
