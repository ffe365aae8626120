#include <mpm_granular/core/vectorize.h>
#include <mpm_granular/materials/pressure_replacement.h>
#include <mpm_granular/materials/stress_columns.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace mpm_granular::Materials
{
  using namespace dealii;

  template <int dim>
  double
  replace_pressure(Points::PointArrays<dim> &points,
                   const Points::Run         run,
                   const double             *target,
                   const double              apex,
                   const ElasticModuli      &moduli)
  {
    const double negligible = negligible_pressure(moduli);
    const double inverse_2K = 1. / (2. * moduli.bulk());
    const double inverse_6G = 1. / (6. * moduli.shear());
    double       released   = 0.;

    // A stress beyond any yield surface, q = 3 p of 90 degrees in compression,
    // which fast flow brings about, does not grow: at hardly pressed points
    // that would be a kick.
    constexpr double steepest = 3.;
    const double     smallest = negligible * negligible;

    constexpr unsigned int       capacity = 64;
    std::array<double, capacity> of_points;
    for (unsigned int begin = run.begin; begin < run.end; begin += capacity)
      {
        const unsigned int n_points = std::min(run.end - begin, capacity);
        const double      *volume   = points.volume.data() + begin;
        const double      *wanted   = target + (begin - run.begin);
        StressColumns<dim> stress(points, begin);
        MPM_INDEPENDENT_ITERATIONS
        for (unsigned int i = 0; i < n_points; ++i)
          {
            const Stress<dim> old      = stress.load(i);
            const double      p        = pressure(old);
            Stress<dim>       s        = deviator(old);
            const double      new_p    = p > negligible ? wanted[i] : p;
            const double      q_square = equivalent_stress_square(s);
            const double      most =
              steepest * (new_p + apex) / std::sqrt(q_square + smallest);
            const double ratio =
              p > negligible ?
                std::min((new_p + apex) / (p + apex), std::max(1., most)) :
                1.;
            for (double &component : s)
              component *= ratio;
            stress.store(i, s, new_p);
            of_points[i] =
              volume[i] * ((p * p - new_p * new_p) * inverse_2K +
                           (1. - ratio * ratio) * q_square * inverse_6G);
          }
        released = std::accumulate(of_points.begin(),
                                   of_points.begin() + n_points,
                                   released);
      }
    return released;
  }

#define INSTANTIATE(dim)                                       \
  template double replace_pressure(Points::PointArrays<dim> &, \
                                   const Points::Run,          \
                                   const double *,             \
                                   const double,               \
                                   const ElasticModuli &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace mpm_granular::Materials
