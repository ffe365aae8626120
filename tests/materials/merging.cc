// Two points become one: sums stay, energies are lost by what the formulas say,
// stress and history fit each other; and the nearest of many, by cell and
// material.

#include "single_point.h"

#include <mpm_granular/materials/merging.h>

#include <algorithm>
#include <set>

using namespace Test;

namespace
{
  constexpr double E = 1e6, nu = .3;
  const double     K = E / (3. * (1. - 2. * nu)), G = E / (2. * (1. + nu));

  /// p^2/(2K) + q^2/(6G), from the components.
  template <int dim>
  double
  energy_density(const Points::PointArrays<dim> &points, const unsigned int i)
  {
    const double p = points.pressure(i);
    double       s = 0.;
    for (unsigned int c = 0; c < n_stress<dim>; ++c)
      {
        const double deviator = points.stress[c][i] + (c < 3 ? p : 0.);
        s += (c < 3 ? 1. : 2.) * deviator * deviator;
      }
    return p * p / (2. * K) + 1.5 * s / (6. * G);
  }

  template <int dim>
  double
  kinetic_energy(const Points::PointArrays<dim> &points, const unsigned int i)
  {
    double square = 0.;
    for (const auto &component : points.velocity)
      square += component[i] * component[i];
    return .5 * points.mass[i] * square;
  }

  /// Mass, volume, momentum, sum of m x, sum of V times slot 0; with their
  /// energies behind.
  template <int dim>
  std::vector<double>
  sums_of(const Points::PointArrays<dim> &points)
  {
    std::vector<double> sums(3 + 2 * dim + 2, 0.);
    for (unsigned int i = 0; i < points.size(); ++i)
      {
        double *sum = sums.data();
        *sum++ += points.mass[i];
        *sum++ += points.volume[i];
        for (unsigned int d = 0; d < dim; ++d)
          {
            *sum++ += points.mass[i] * points.velocity[d][i];
            *sum++ += points.mass[i] * points.position[d][i];
          }
        *sum++ += points.volume[i] * points.history[0][i];
        *sum++ += kinetic_energy(points, i);
        *sum++ += points.volume[i] * energy_density(points, i);
      }
    return sums;
  }

  /// Whether all sums but the energies agree, and those are less by what
  /// merge() says.
  template <int dim>
  bool
  is_closed(const Points::PointArrays<dim> &before,
            const Points::PointArrays<dim> &after,
            const Materials::MergingLoss   &loss)
  {
    auto old_sums = sums_of(before);
    old_sums[old_sums.size() - 2] -= loss.kinetic;
    old_sums[old_sums.size() - 1] -= loss.elastic;
    const auto new_sums = sums_of(after);
    bool       agree    = before.size() == after.size() + loss.n_points;
    for (unsigned int i = 0; i < old_sums.size(); ++i)
      agree = agree && std::abs(new_sums[i] - old_sums[i]) <=
                         1e-13 * (1. + std::abs(old_sums[i]));
    return agree;
  }

  template <int dim>
  Points::PointArrays<dim>
  two_points(const Materials::ConstitutiveLaw<dim> &law,
             const Stress<dim>                     &first,
             const Stress<dim>                     &second)
  {
    Points::PointArrays<dim> points;
    points.resize(2, std::max<unsigned int>(1, law.history_names().size()));
    points.mass   = {3., 1.};
    points.volume = {2., 3.};
    points.id     = {8, 5};
    for (unsigned int d = 0; d < dim; ++d)
      {
        points.position[d] = {.1 + d, .5};
        points.velocity[d] = {1., 2. * d};
      }
    for (unsigned int c = 0; c < n_stress<dim>; ++c)
      points.stress[c] = {first[c], second[c]};
    law.initialize(points, {0, 2});
    points.history[0] = {.5, 1.};
    return points;
  }
} // namespace

/// One in contact, the other with a gap, as the slot 1 of the law says.
template <int dim>
void
test_pair(const std::string              &name,
          const std::vector<std::string> &entries,
          const double                    of_gap)
{
  std::vector<std::string> all{"Young modulus=1e6", "Poisson ratio=0.3"};
  all.insert(all.end(), entries.begin(), entries.end());
  const auto law = make_law<dim>(name, all);

  const double pressure = 2e4;
  auto         points   = two_points<dim>(*law,
                                pressure_and_shear<dim>(pressure, 3e3),
                                pressure_and_shear<dim>(0., 0.));
  if (law->history_names().size() > 1)
    points.history[1][1] = of_gap;
  const auto before = points;
  const auto loss   = Materials::merge<dim>(points, {law.get()}, 1);

  std::cout << dim << "D, " << name << ": id " << points.id[0] << ", mass "
            << points.mass[0] << ", volume " << points.volume[0] << ", at "
            << points.location(0) << ", closed "
            << is_closed(before, points, loss) << ", lost "
            << (loss.kinetic > 0. && loss.elastic > 0.) << std::endl;
  // Volumes 2 and 3: 2/5 of the pressure, less what closes 3/5 of the gap.
  const double mean = .4 * pressure;
  const double p    = law->history_names().size() > 1 ?
                        std::max(0., mean - K * .6 * of_gap) :
                        mean;
  compare("  1 kPa more than the pressure",
          1. + points.pressure(0) / 1e3,
          1. + p / 1e3,
          1e-10);
  compare("  1 kPa more than the shear stress",
          1. + points.stress[3][0] / 1e3,
          1. + .4 * 3. * p / mean,
          1e-10);
  // Relative velocity, reduced mass 3 * 1 / 4.
  double square = 1.;
  for (unsigned int d = 1; d < dim; ++d)
    square += (2. * d - 1.) * (2. * d - 1.);
  compare("  kinetic energy lost", loss.kinetic, .5 * .75 * square, 1e-12);
  if (law->history_names().size() > 1)
    std::cout << "  history " << points.history[0][0] << ' '
              << points.history[1][0] << std::endl;
}

/// Many, in three cells, of two materials.
template <int dim>
void
test_many()
{
  const auto law =
    make_law<dim>(elastic, {"Young modulus=1e6", "Poisson ratio=0.3"});
  Points::PointArrays<dim> points;
  const unsigned int       n = 60;
  points.resize(n, 1);
  const auto scattered = [](const unsigned int i) {
    const double x = .6180339887498949 * (i + 1);
    return x - static_cast<unsigned int>(x);
  };
  for (unsigned int i = 0; i < n; ++i)
    {
      unsigned int next = 31 * i;
      points.id[i]      = (7 * i) % n;
      // Cell 0 has few points; the others have both materials.
      points.cell[i]       = i < 4 ? 0 : i < 30 ? 1 : 2;
      points.material[i]   = points.cell[i] == 2 && i % 10 == 0 ? 1 : 0;
      points.mass[i]       = 1. + scattered(next++);
      points.volume[i]     = 1. + scattered(next++);
      points.history[0][i] = scattered(next++);
      for (auto &component : points.position)
        component[i] = scattered(next++);
      for (auto &component : points.velocity)
        component[i] = scattered(next++);
      for (auto &component : points.stress)
        component[i] = 1e3 * scattered(next++);
    }
  const auto before = points;
  for (const unsigned int most : {5, 1})
    {
      points = before;
      const auto loss =
        Materials::merge<dim>(points, {law.get(), law.get()}, most);
      std::cout << dim << "D, at most " << most << ": " << points.size()
                << " points, in cells";
      for (const unsigned int cell : {0, 1, 2})
        std::cout << ' '
                  << std::count(points.cell.begin(), points.cell.end(), cell);
      const std::set<unsigned int> ids(points.id.begin(), points.id.end());
      std::cout << ", materials of mass";
      for (const unsigned int material : {0, 1})
        {
          double mass = 0., mass_before = 0.;
          for (unsigned int i = 0; i < points.size(); ++i)
            mass += points.material[i] == material ? points.mass[i] : 0.;
          for (unsigned int i = 0; i < n; ++i)
            mass_before += before.material[i] == material ? before.mass[i] : 0.;
          std::cout << (std::abs(mass - mass_before) < 1e-12 ? " kept" :
                                                               " LOST");
        }
      std::cout << ", ids " << ids.size() << " from " << *ids.begin()
                << ", closed " << is_closed(before, points, loss) << std::endl;
    }
}

int
main()
{
  const std::vector<std::string> strength{"Cohesion=1e3", "Friction angle=30"};
  // Some of the gap is left, or some of the pressure.
  test_pair<2>(granular, {}, .005);
  test_pair<3>(granular, {}, .05);
  test_pair<2>("Mohr-Coulomb", {"Friction angle=30"}, .005);
  test_pair<3>("Mohr-Coulomb", {"Friction angle=30"}, .05);
  test_pair<2>(elastic, {}, 0.);
  test_many<2>();
  test_many<3>();
}
