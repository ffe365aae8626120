#ifndef mpm_granular_points_motion_h
#define mpm_granular_points_motion_h

#include <mpm_granular/points/point_arrays.h>

namespace mpm_granular::Points
{
  /// How fast points move, summed up.
  struct Motion
  {
    double kinetic_energy = 0.; ///< [J], in 2D [J/m]
    double speed_squared  = 0.; ///< of the fastest point [m^2/s^2]

    void
    operator+=(const Motion &other);
  };

  /// The motion of points [begin, end). A value that is not a number makes the
  /// kinetic energy not a number.
  template <int dim>
  Motion
  motion_of(const PointArrays<dim> &points,
            const unsigned int      begin,
            const unsigned int      end);
} // namespace mpm_granular::Points

#endif
