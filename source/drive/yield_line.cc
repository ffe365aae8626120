#include <deal.II/base/array_view.h>

#include <mpm_granular/drive/yield_line.h>
#include <mpm_granular/materials/stress_update.h>

#include <algorithm>
#include <cmath>

namespace mpm_granular::Drive
{
  using namespace dealii;

  namespace
  {
    /// Whether a stress changes without strain.
    bool
    flows(const Materials::ConstitutiveLaw<3> &law,
          Points::PointArrays<3>              &point,
          const Stress<3>                     &deviator,
          const double                         pressure)
    {
      Stress<3> before;
      double    size = std::abs(pressure);
      for (unsigned int c = 0; c < n_stress<3>; ++c)
        {
          before[c]          = deviator[c] - (c < 3 ? pressure : 0.);
          point.stress[c][0] = before[c];
          size               = std::max(size, std::abs(before[c]));
        }
      point.volume[0] = 1.;
      law.initialize(point, {0, 1});
      const Points::Run  run{0, 1};
      const Tensor<2, 3> no_strain;
      // Long, so that viscous stresses change visibly.
      constexpr double time_step = 1.; // s
      Materials::update_stress<3>(law,
                                  point,
                                  make_array_view(&run, &run + 1),
                                  make_array_view(&no_strain, &no_strain + 1),
                                  time_step);
      double change = 0.;
      for (unsigned int c = 0; c < n_stress<3>; ++c)
        change = std::max(change, std::abs(point.stress[c][0] - before[c]));
      return change > 1e-12 * size;
    }
  } // namespace



  std::vector<std::pair<double, double>>
  yield_line(const Materials::ConstitutiveLaw<3> &law,
             const Stress<3>                     &direction,
             const double                         lowest,
             const double                         highest)
  {
    constexpr unsigned int n_pressures = 101, n_bisections = 60;

    Points::PointArrays<3> point;
    point.resize(1, law.history_names().size());
    const double size      = Materials::equivalent_stress(direction);
    const auto   is_beyond = [&](const double q, const double pressure) {
      Stress<3> deviator = direction;
      for (double &component : deviator)
        component *= q / size;
      return flows(law, point, deviator, pressure);
    };

    std::vector<std::pair<double, double>> line;
    for (unsigned int k = 0; k < n_pressures; ++k)
      {
        const double pressure =
          lowest + (highest - lowest) * k / (n_pressures - 1.);
        double lower = 0.,
               upper = 100. * std::max(std::abs(lowest), std::abs(highest));
        if (is_beyond(lower, pressure) || !is_beyond(upper, pressure))
          continue;
        for (unsigned int n = 0; n < n_bisections; ++n)
          {
            const double middle = .5 * (lower + upper);
            (is_beyond(middle, pressure) ? upper : lower) = middle;
          }
        line.emplace_back(pressure, lower);
      }
    return line;
  }
} // namespace mpm_granular::Drive
