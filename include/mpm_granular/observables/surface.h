#ifndef mpm_granular_observables_surface_h
#define mpm_granular_observables_surface_h

#include <deal.II/base/mpi.h>

#include <mpm_granular/observables/frame.h>
#include <mpm_granular/points/point_arrays.h>

#include <vector>

namespace mpm_granular::Observables
{
  /**
   * The surface of the body seen from the side: its height in bins along the
   * run-out, over the whole mesh.
   */
  struct Surface
  {
    double              start;  ///< lower end of the first bin [m]
    double              width;  ///< of a bin [m]
    std::vector<double> height; ///< of each bin; 0 where there is no point [m]

    /// The middle of a bin [m].
    double
    position(const unsigned int bin) const
    {
      return start + (bin + 0.5) * width;
    }

    /// Area below the surface, seen from the side [m^2].
    double
    area() const;
  };

  /**
   * The height of a column is that of its highest point, plus half the spacing
   * of points there, V^(1/dim)/2, because a point is in the middle of its
   * volume. In 3D the height of a bin is the mean over the depth of columns
   * that are as deep as the bin is wide, so that the area is the volume below
   * the surface over the depth of the mesh.
   *
   * @param points the points of this rank.
   * @param communicator of the ranks that hold points; collective.
   * @param frame where along, up and across are.
   * @param bin_width [m].
   */
  template <int dim>
  Surface
  find_surface(const Points::PointArrays<dim> &points,
               const MPI_Comm                  communicator,
               const Frame<dim>               &frame,
               const double                    bin_width);
} // namespace mpm_granular::Observables

#endif
