#include <mpm_granular/points/motion.h>

#include <algorithm>

namespace mpm_granular::Points
{
  void
  Motion::operator+=(const Motion &other)
  {
    kinetic_energy += other.kinetic_energy;
    speed_squared = std::max(speed_squared, other.speed_squared);
  }

  template <int dim>
  Motion
  motion_of(const PointArrays<dim> &points,
            const unsigned int      begin,
            const unsigned int      end)
  {
    // Pointers to the first of the points and a wide index: a loop over indices
    // that may wrap is vectorized by gathering single numbers.
    const std::size_t               n_points = end - begin;
    const double                   *mass     = points.mass.data() + begin;
    std::array<const double *, dim> velocity;
    for (unsigned int d = 0; d < dim; ++d)
      velocity[d] = points.velocity[d].data() + begin;
    double energy = 0., fastest = 0.;
#pragma omp simd reduction(+ : energy) reduction(max : fastest)
    for (std::size_t p = 0; p < n_points; ++p)
      {
        double square = velocity[0][p] * velocity[0][p];
        for (unsigned int d = 1; d < dim; ++d)
          square += velocity[d][p] * velocity[d][p];
        energy += .5 * mass[p] * square;
        fastest = std::max(fastest, square);
      }
    return {energy, fastest};
  }

  template Motion
  motion_of(const PointArrays<2> &, const unsigned int, const unsigned int);
  template Motion
  motion_of(const PointArrays<3> &, const unsigned int, const unsigned int);
} // namespace mpm_granular::Points
