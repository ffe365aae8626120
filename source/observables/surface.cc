#include <deal.II/base/exceptions.h>

#include <mpm_granular/observables/surface.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mpm_granular::Observables
{
  using namespace dealii;

  double
  Surface::area() const
  {
    return width * std::accumulate(height.begin(), height.end(), 0.);
  }



  template <int dim>
  Surface
  find_surface(const Points::PointArrays<dim> &points,
               const Frame<dim>               &frame,
               const double                    bin_width)
  {
    Assert(bin_width > 0., ExcMessage("Bins need a width."));
    // A mesh that holds a whole number of bins up to round-off holds no more.
    const int n_bins =
      std::max(1.,
               std::ceil((frame.end - frame.start) / bin_width * (1. - 1e-9)));
    Surface surface{frame.start, bin_width, std::vector<double>(n_bins, 0.)};
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        const Point<dim> x        = points.location(i);
        const double     position = (frame.along * x - frame.start) / bin_width;
        const int bin = std::clamp(static_cast<int>(position), 0, n_bins - 1);
        const double half_spacing = 0.5 * std::pow(points.volume[i], 1. / dim);
        surface.height[bin] =
          std::max(surface.height[bin], frame.height(x) + half_spacing);
      }
    return surface;
  }



  template Surface
  find_surface(const Points::PointArrays<2> &, const Frame<2> &, const double);
  template Surface
  find_surface(const Points::PointArrays<3> &, const Frame<3> &, const double);
} // namespace mpm_granular::Observables
