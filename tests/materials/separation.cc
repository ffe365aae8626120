// Opening and closing a point (T7): what the pressure is for each rule of
// 'Separation' follows from the logarithm of the volume alone, path by path. An
// open point has no stress, whatever its shear, and none comes back with the
// pressure.

#include "single_point.h"

#include <limits>

using namespace Test;

constexpr double K = 1e6 / 1.2;

template <int dim>
void
test(const std::vector<std::string> &entries, const double cap)
{
  std::cout << entries[0] << ", " << dim << "D" << std::endl;
  // ln J_s begins at not quite -0.01, so that no step ends at exactly 0.
  SinglePoint<dim> point(granular,
                         entries,
                         pressure_and_shear<dim>(8333.3333, 2000.));
  double           log_ratio = -8333.3333 / K, log_volume = 0., q_open = 0.,
         volume_error = 0.;
  unsigned int n_open = 0, n_wrong = 0;

  // Swelling and shrinking, with shear all the time: the last visit to contact
  // is after a gap beyond the cap.
  for (const double change : {.02, -.02, .2, -.15, -.06, .001})
    for (unsigned int n = 0; n < 50; ++n)
      {
        const double   time_step = 1e-3, ratio = std::exp(change / 50.);
        Tensor<2, dim> gradient = simple_shear<dim>(3.);
        for (unsigned int d = 0; d < dim; ++d)
          gradient[d][d] = (std::pow(ratio, 1. / dim) - 1.) / time_step;
        point.step(gradient, time_step);

        log_volume += change / 50.;
        log_ratio               = std::min(log_ratio + change / 50., cap);
        const double expected_p = std::max(-K * log_ratio, 0.);
        if (std::abs(point.pressure() - expected_p) > 1e-6 ||
            std::abs(point.history(1) - log_ratio) > 1e-12)
          ++n_wrong;
        volume_error =
          std::max(volume_error,
                   std::abs(std::log(point.volume()) - log_volume));
        if (log_ratio >= 0.)
          {
            ++n_open;
            q_open = std::max(q_open, point.equivalent_stress());
          }
      }
  compare("  steps with a wrong pressure or volume ratio", n_wrong, 0., 0., 1.);
  compare("  volume", volume_error, 0., 1e-12, 1.);
  compare("  q of the open point", q_open, 0., 0., 1.);
  std::cout << "  open in " << n_open
            << " of 300 steps, at the end p = " << point.pressure() / 1e3
            << " kPa" << std::endl;
}

/// The energy that opening releases is that of the deviator; compressing an
/// open point takes none.
void
test_energy()
{
  const double   p = 100., tau = 50., time_step = 1e-3, G = 1e6 / 2.6;
  SinglePoint<3> point(granular, {}, pressure_and_shear<3>(p, tau));
  Tensor<2, 3>   swelling;
  for (unsigned int d = 0; d < 3; ++d)
    swelling[d][d] = 1e-3 / time_step;
  const double released = point.step(swelling, time_step);
  // q^2/(6G) = tau^2/(2G).
  compare("energy released by opening, mJ",
          1e3 * released,
          1e3 * point.volume() * tau * tau / (2. * G),
          1e-12);
  compare("energy released by closing",
          point.step(-1. * swelling, time_step),
          0.,
          1e-15,
          1.);
}

int
main()
{
  const double infinity = std::numeric_limits<double>::infinity();
  test<2>({"Separation=track"}, infinity);
  test<3>({"Separation=track"}, infinity);
  test<2>({"Separation=reset"}, 0.);
  test<3>({"Separation=reset"}, 0.);
  test<2>({"Separation=capped", "Log volume ratio cap=0.08"}, .08);
  test<3>({"Separation=capped", "Log volume ratio cap=0.08"}, .08);
  test_energy();
}
