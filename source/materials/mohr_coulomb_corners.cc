#include <boost/math/tools/toms748_solve.hpp>

#include <mpm_granular/materials/mohr_coulomb_corners.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace mpm_granular::Materials
{
  namespace
  {
    using Constants = MohrCoulombConstants;

    /// A plane n . sigma <= limit, and the stress that flow takes off.
    struct Plane
    {
      PrincipalStress normal;
      PrincipalStress drop; ///< by a multiplier of 1
      double          limit;
    };



    /// The planes of Mohr and Coulomb with the stress times @p factor, and those
    /// of the tension cut-off.
    std::array<Plane, 6>
    planes_of(const Constants &constants, const double factor)
    {
      constexpr unsigned int pairs[3][2] = {{0, 2}, {0, 1}, {1, 2}};
      const double           lame =
        constants.bulk - 2. / 3. * constants.shear; // first Lame constant
      std::array<Plane, 6> planes{};
      const auto           set_drop = [&](Plane                 &plane,
                                const PrincipalStress &direction) {
        const double sum = direction[0] + direction[1] + direction[2];
        for (unsigned int i = 0; i < 3; ++i)
          plane.drop[i] = 2. * constants.shear * direction[i] + lame * sum;
      };
      for (unsigned int k = 0; k < 3; ++k)
        {
          const auto [larger, smaller] = pairs[k];
          PrincipalStress direction{};
          planes[k].normal[larger]  = factor + constants.sine;
          planes[k].normal[smaller] = constants.sine - factor;
          planes[k].limit           = constants.cohesion_term;
          direction[larger]         = 1. + constants.dilatancy_sine;
          direction[smaller]        = constants.dilatancy_sine - 1.;
          set_drop(planes[k], direction);

          PrincipalStress axis{};
          axis[k]              = 1.;
          planes[3 + k].normal = axis;
          planes[3 + k].limit  = constants.tension;
          set_drop(planes[3 + k], axis);
        }
      return planes;
    }



    double
    product(const PrincipalStress &one, const PrincipalStress &other)
    {
      return one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
    }



    /// Up to three of the six planes.
    struct ActiveSet
    {
      std::array<unsigned int, 3> planes{};
      unsigned int                size = 0;
    };

    struct Candidate
    {
      PrincipalStress sigma;
      double          multiplier; ///< of the planes of Mohr and Coulomb
      double          violation;  ///< of any condition [Pa]
    };



    /// The stress on all planes of a set; none if they are not independent.
    std::optional<Candidate>
    on_planes(const PrincipalStress      &trial,
              const std::array<Plane, 6> &planes,
              const ActiveSet            &set,
              const double                shear)
    {
      const auto        &active   = set.planes;
      const unsigned int n_active = set.size;
      // Gauss with pivots.
      double A[3][4] = {};
      for (unsigned int r = 0; r < n_active; ++r)
        {
          const Plane &plane = planes[active[r]];
          for (unsigned int c = 0; c < n_active; ++c)
            A[r][c] = product(plane.normal, planes[active[c]].drop);
          A[r][n_active] = product(plane.normal, trial) - plane.limit;
        }
      for (unsigned int k = 0; k < n_active; ++k)
        {
          unsigned int pivot = k;
          for (unsigned int r = k + 1; r < n_active; ++r)
            if (std::abs(A[r][k]) > std::abs(A[pivot][k]))
              pivot = r;
          if (std::abs(A[pivot][k]) < 1e-10 * shear)
            return {};
          std::swap(A[k], A[pivot]);
          for (unsigned int r = 0; r < n_active; ++r)
            if (r != k)
              {
                const double factor = A[r][k] / A[k][k];
                for (unsigned int c = k; c <= n_active; ++c)
                  A[r][c] -= factor * A[k][c];
              }
        }

      Candidate result{trial, 0., 0.};
      for (unsigned int k = 0; k < n_active; ++k)
        {
          const double lambda = A[k][n_active] / A[k][k];
          for (unsigned int i = 0; i < 3; ++i)
            result.sigma[i] -= lambda * planes[active[k]].drop[i];
          if (active[k] < 3)
            result.multiplier += lambda;
          result.violation = std::max(result.violation, -lambda * shear);
        }
      for (const Plane &plane : planes)
        result.violation =
          std::max(result.violation,
                   product(plane.normal, result.sigma) - plane.limit);
      return result;
    }



    /// All sets of one plane, then those of two and of three.
    std::vector<ActiveSet>
    all_sets()
    {
      std::vector<ActiveSet> sets;
      for (unsigned int size = 1; size <= 3; ++size)
        for (unsigned int bits = 0; bits < 64; ++bits)
          {
            ActiveSet    set;
            unsigned int n_bits = 0;
            for (unsigned int plane = 0; plane < 6; ++plane)
              if ((bits >> plane) % 2 == 1 && n_bits++ < 3)
                set.planes[set.size++] = plane;
            if (n_bits == size)
              sets.push_back(set);
          }
      return sets;
    }



    /**
     * The rate-independent return for the stress times @p factor: the set of
     * active planes that fulfills all conditions (T57a).
     *
     * @param set tried first, if it is not empty; then the one found.
     */
    Candidate
    return_to_planes(const PrincipalStress &trial,
                     const Constants       &constants,
                     const double           factor,
                     ActiveSet             &set)
    {
      static const std::vector<ActiveSet> sets = all_sets();

      const auto   planes = planes_of(constants, factor);
      const double tolerance =
        1e-12 *
        std::max({std::abs(trial[0]), std::abs(trial[2]), constants.tension});
      Candidate       best{{}, 0., std::numeric_limits<double>::infinity()};
      const ActiveSet first    = set;
      const auto      try_this = [&](const ActiveSet &other) {
        const auto candidate = on_planes(trial, planes, other, constants.shear);
        if (candidate && candidate->violation < best.violation)
          {
            best = *candidate;
            set  = other;
          }
        return best.violation <= tolerance;
      };
      if (first.size > 0 && try_this(first))
        return best;
      for (const ActiveSet &other : sets)
        if (try_this(other))
          return best;
      return best;
    }
  } // namespace



  PrincipalStress
  return_to_corner(const PrincipalStress      &trial,
                   const MohrCoulombConstants &constants,
                   const PerzynaStep          &step)
  {
    ActiveSet       set;
    const Candidate without_rate = return_to_planes(trial, constants, 1., set);
    if (std::isinf(step.amount) || without_rate.multiplier <= 0.)
      return without_rate.sigma;
    const auto excess = [&](const double factor) {
      const double multiplier =
        std::max(return_to_planes(trial, constants, factor, set).multiplier,
                 0.);
      return factor * std::pow(multiplier / step.amount, 1. / step.exponent) -
             (1. - factor);
    };
    const boost::math::tools::eps_tolerance<double> tolerance(46);
    std::uintmax_t                                  n_iterations = 200;
    const double at_upper = excess(1.), at_lower = excess(0.);
    const auto   bracket = boost::math::tools::toms748_solve(
      excess, 0., 1., at_lower, at_upper, tolerance, n_iterations);
    const double factor = .5 * (bracket.first + bracket.second);
    return return_to_planes(trial, constants, factor, set).sigma;
  }
} // namespace mpm_granular::Materials
