#ifndef mpm_granular_observables_mass_quantile_h
#define mpm_granular_observables_mass_quantile_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/tensor.h>

#include <mpm_granular/points/point_arrays.h>

#include <limits>

namespace mpm_granular::Observables
{
  /// What lies between two parallel planes: lower <= normal . x <= upper.
  template <int dim>
  struct Slab
  {
    dealii::Tensor<1, dim> normal;
    double lower = std::numeric_limits<double>::lowest(); ///< [m]
    double upper = std::numeric_limits<double>::max();    ///< [m]
  };

  /**
   * The coordinate along a direction up to which a given fraction of the mass
   * lies.
   *
   * Found by histograms, each refining the bin of the one before: it needs sums
   * over the points only, no order and no copies.
   *
   * @param points the points of this rank.
   * @param communicator of the ranks that hold points; collective.
   * @param direction a unit vector.
   * @param fraction of the mass, above 0 and up to 1; 1e-9 of it may be missing,
   *   so that the round-off of sums does not matter.
   * @param slab only points in there count.
   * @return the coordinate of a point [m], up to 1e-9 of the range of all
   *   coordinates; NaN if there is no point.
   */
  template <int dim>
  double
  mass_quantile(const Points::PointArrays<dim> &points,
                const MPI_Comm                  communicator,
                const dealii::Tensor<1, dim>   &direction,
                const double                    fraction,
                const Slab<dim>                &slab = {});
} // namespace mpm_granular::Observables

#endif
