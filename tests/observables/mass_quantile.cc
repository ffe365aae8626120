// The quantile by histograms against the definition: sort the points, add up
// masses until the fraction is reached, up to 1e-9 of it as promised.

#include <mpm_granular/observables/mass_quantile.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <random>
#include <utility>
#include <vector>

using namespace dealii;
using namespace mpm_granular;

template <int dim>
double
reference(const Points::PointArrays<dim> &points,
          const Tensor<1, dim>           &direction,
          const double                    fraction,
          const Observables::Slab<dim>   &slab)
{
  std::vector<std::pair<double, double>> sorted;
  double                                 total = 0.;
  for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Point<dim> x        = points.location(i);
      const double     distance = slab.normal * x;
      if (distance < slab.lower || distance > slab.upper)
        continue;
      sorted.emplace_back(direction * x, points.mass[i]);
      total += points.mass[i];
    }
  std::sort(sorted.begin(), sorted.end());
  double sum = 0.;
  for (const auto &[x, mass] : sorted)
    {
      sum += mass;
      if (sum >= fraction * total * (1. - 1e-9))
        return x;
    }
  return std::nan("");
}



template <int dim>
Points::PointArrays<dim>
random_points(const unsigned int n, const bool equal_masses)
{
  std::mt19937             generator(n);
  Points::PointArrays<dim> points;
  const auto               random = [&] { return generator() / 4294967296.; };
  for (unsigned int i = 0; i < n; ++i)
    {
      points.for_each_array([](auto &array) { array.push_back(0); });
      for (unsigned int d = 0; d < dim; ++d)
        points.position[d][i] = -3. + 10. * std::pow(random(), 3.);
      points.mass[i] = equal_masses ? 0.1 : std::pow(random(), 4.) + 1e-6;
    }
  return points;
}



template <int dim>
void
compare(const unsigned int n, const bool equal_masses)
{
  const auto     points = random_points<dim>(n, equal_masses);
  Tensor<1, dim> oblique;
  for (unsigned int d = 0; d < dim; ++d)
    oblique[d] = d + 1.;
  oblique /= oblique.norm();

  double error = 0.;
  for (const auto &direction :
       {Tensor<1, dim>(Point<dim>::unit_vector(0)), oblique, -oblique})
    for (const double fraction : {1e-9, 0.1, 0.25, 0.5, 0.999, 1.})
      for (const auto &slab :
           {Observables::Slab<dim>(),
            Observables::Slab<dim>{Point<dim>::unit_vector(1), -2.5, 1.}})
        error = std::max(error,
                         std::abs(
                           Observables::mass_quantile(
                             points, MPI_COMM_SELF, direction, fraction, slab) -
                           reference(points, direction, fraction, slab)));
  // The range of the coordinates is about 10.
  std::cout << dim << "D, " << n << " points, "
            << (equal_masses ? "equal" : "unequal")
            << " masses: " << (error < 1e-8 ? "agrees" : "WRONG") << std::endl;
  if (!(error < 1e-8))
    std::cout << "error " << error << std::endl;
}



void
special_cases()
{
  const Tensor<1, 2>     x = Point<2>::unit_vector(0);
  Points::PointArrays<2> points;
  std::cout << "No point: "
            << std::isnan(
                 Observables::mass_quantile(points, MPI_COMM_SELF, x, 0.5))
            << std::endl;

  for (const double place : {2., 2., 2.})
    {
      points.for_each_array([](auto &array) { array.push_back(0); });
      points.position[0].back() = place;
      points.mass.back()        = 1.;
    }
  std::cout << "All at one place: "
            << Observables::mass_quantile(points, MPI_COMM_SELF, x, 0.999)
            << std::endl;

  points.position[0][0] = 1.;
  points.position[0][2] = 1e6;
  points.mass[2]        = 1e-3;
  std::cout << "A light one far away, 99.9 %: "
            << Observables::mass_quantile(points, MPI_COMM_SELF, x, 0.999)
            << ", all: "
            << Observables::mass_quantile(points, MPI_COMM_SELF, x, 1.)
            << std::endl;
  std::cout
    << "Outside of the slab: "
    << std::isnan(Observables::mass_quantile<2>(
         points, MPI_COMM_SELF, x, 0.5, {Point<2>::unit_vector(1), 5., 6.}))
    << std::endl;
}



int
main()
{
  for (const unsigned int n : {1, 2, 3, 10, 1000, 20000})
    for (const bool equal_masses : {true, false})
      {
        compare<2>(n, equal_masses);
        compare<3>(n, equal_masses);
      }
  special_cases();
}
