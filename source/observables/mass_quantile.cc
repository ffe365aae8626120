#include <mpm_granular/observables/mass_quantile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace mpm_granular::Observables
{
  using namespace dealii;

  namespace
  {
    constexpr int n_bins = 256;

    /// 256^4 bins in the end: 2e-10 of the range.
    constexpr unsigned int n_refinements = 4;

    /// Calls @p action(coordinate, mass) for each point in the slab.
    template <int dim, class Action>
    void
    for_each_point(const Points::PointArrays<dim> &points,
                   const Tensor<1, dim>           &direction,
                   const Slab<dim>                &slab,
                   Action                        &&action)
    {
      for (std::size_t i = 0; i < points.size(); ++i)
        {
          const Point<dim> x        = points.location(i);
          const double     distance = slab.normal * x;
          if (distance >= slab.lower && distance <= slab.upper)
            action(direction * x, points.mass[i]);
        }
    }
  } // namespace



  template <int dim>
  double
  mass_quantile(const Points::PointArrays<dim> &points,
                const MPI_Comm                  communicator,
                const Tensor<1, dim>           &direction,
                const double                    fraction,
                const Slab<dim>                &slab)
  {
    double lower = std::numeric_limits<double>::max();
    double upper = std::numeric_limits<double>::lowest();
    double mass  = 0.;
    for_each_point(points,
                   direction,
                   slab,
                   [&](const double x, const double m) {
                     lower = std::min(lower, x);
                     upper = std::max(upper, x);
                     mass += m;
                   });
    lower = Utilities::MPI::min(lower, communicator);
    upper = Utilities::MPI::max(upper, communicator);
    mass  = Utilities::MPI::sum(mass, communicator);
    if (lower > upper)
      return std::numeric_limits<double>::quiet_NaN();

    // Ranges and bins are open below and closed above: (lower, upper].
    lower = std::nextafter(lower, std::numeric_limits<double>::lowest());

    // The wanted mass counted from the lower end of the current range; a little
    // less, so that the round-off of sums cannot put it beyond the point that
    // completes it.
    double remaining = fraction * mass * (1. - 1e-9);
    for (unsigned int r = 0; r < n_refinements; ++r)
      {
        const double width = (upper - lower) / n_bins;
        if (!(lower + width > lower))
          break;
        const auto edge = [&](const int bin) {
          return bin == n_bins ? upper : lower + bin * width;
        };
        std::array<double, n_bins> sums = {};
        for_each_point(points, direction, slab, [&](const double x, double m) {
          if (!(x > lower && x <= upper))
            return;
          int bin = std::min(static_cast<int>((x - lower) / width), n_bins - 1);
          // Round-off must not put a point into two bins or none.
          if (bin > 0 && x <= edge(bin))
            --bin;
          else if (x > edge(bin + 1))
            ++bin;
          sums[bin] += m;
        });
        Utilities::MPI::sum(ArrayView<const double>(sums.data(), n_bins),
                            communicator,
                            ArrayView<double>(sums.data(), n_bins));
        int bin = 0;
        while (bin + 1 < n_bins && remaining > sums[bin])
          remaining -= sums[bin++];
        const double bin_upper = edge(bin + 1);
        lower                  = edge(bin);
        upper                  = bin_upper;
      }

    double highest = lower;
    for_each_point(points, direction, slab, [&](const double x, double) {
      if (x > highest && x <= upper)
        highest = x;
    });
    return Utilities::MPI::max(highest, communicator);
  }



  template double
  mass_quantile(const Points::PointArrays<2> &,
                const MPI_Comm,
                const Tensor<1, 2> &,
                const double,
                const Slab<2> &);
  template double
  mass_quantile(const Points::PointArrays<3> &,
                const MPI_Comm,
                const Tensor<1, 3> &,
                const double,
                const Slab<3> &);
} // namespace mpm_granular::Observables
