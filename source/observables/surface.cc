#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

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
               const MPI_Comm                  communicator,
               const Frame<dim>               &frame,
               const double                    bin_width)
  {
    Assert(bin_width > 0., ExcMessage("Bins need a width."));
    // A mesh that holds a whole number of bins up to round-off holds no more.
    const int n_bins =
      std::max(1.,
               std::ceil((frame.end - frame.start) / bin_width * (1. - 1e-9)));
    const double depth     = frame.right - frame.left;
    const int    n_columns = std::max(1., std::round(depth / bin_width));

    std::vector<double> heights(n_bins * n_columns, 0.);
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        const Point<dim> x = points.location(i);
        const int        bin =
          std::clamp<int>((frame.along * x - frame.start) / bin_width,
                          0,
                          n_bins - 1);
        const int column =
          n_columns == 1 ?
            0 :
            std::clamp<int>((frame.across * x - frame.left) / depth * n_columns,
                            0,
                            n_columns - 1);
        const double half_spacing = 0.5 * std::pow(points.volume[i], 1. / dim);
        double      &height       = heights[bin * n_columns + column];
        height = std::max(height, frame.height(x) + half_spacing);
      }

    Utilities::MPI::max(heights, communicator, heights);

    Surface surface{frame.start, bin_width, std::vector<double>(n_bins, 0.)};
    for (int bin = 0; bin < n_bins; ++bin)
      for (int column = 0; column < n_columns; ++column)
        surface.height[bin] += heights[bin * n_columns + column] / n_columns;
    return surface;
  }



  template Surface
  find_surface(const Points::PointArrays<2> &,
               const MPI_Comm,
               const Frame<2> &,
               const double);
  template Surface
  find_surface(const Points::PointArrays<3> &,
               const MPI_Comm,
               const Frame<3> &,
               const double);
} // namespace mpm_granular::Observables
