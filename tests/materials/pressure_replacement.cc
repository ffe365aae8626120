// A point's pressure is replaced by a given one (T29): q/p is kept, but no
// deviator beyond any yield surface becomes larger than q = 3 p', and nothing
// happens at points without contact. What it returns is the
// elastic energy p^2/2K + q^2/6G that is taken out.

#include "single_point.h"

#include <mpm_granular/materials/pressure_replacement.h>

using namespace Test;

// Of the moduli that are usual, E = 1 MPa and nu = 0.3.
constexpr double K = 1e6 / 1.2, G = 1e6 / 2.6;

struct Case
{
  std::string text;
  double      p, q, target, apex;
  double      new_p, new_q; // by hand
};

const std::vector<Case> cases = {
  {"down, q/p is kept", 4e3, 2e3, 3e3, 0., 3e3, 1.5e3},
  {"up, below q = 3 p'", 1e3, 2e3, 4e3, 0., 4e3, 8e3},
  {"up, from q = 5 p to 3 p'", 1e3, 5e3, 4e3, 0., 4e3, 12e3},
  {"up, beyond 3 p' already", 1e3, 1e4, 3e3, 0., 3e3, 1e4},
  {"down, beyond 3 p'", 1e3, 1e4, 5e2, 0., 5e2, 5e3},
  {"to nothing", 1e3, 5e2, 0., 0., 0., 0.},
  {"pressures count from the apex", 1e3, 2e3, 4e3, 2e3, 4e3, 4e3},
  {"without contact", 0., 5e2, 4e3, 0., 0., 5e2},
  {"in tension", -1e3, 5e2, 4e3, 2e3, -1e3, 5e2}};

template <int dim>
void
test()
{
  std::cout << dim << "D" << std::endl;
  for (const auto &c : cases)
    {
      SinglePoint<dim> point(granular,
                             {},
                             pressure_and_shear<dim>(c.p, c.q / std::sqrt(3.)));
      const double     released = Materials::replace_pressure<dim>(
        point.points, {0, 1}, &c.target, c.apex, {});
      const auto energy = [](const double p, const double q) {
        return p * p / (2. * K) + q * q / (6. * G);
      };
      std::cout << c.text << std::endl;
      compare("  p", point.pressure() / 1e3, c.new_p / 1e3, 1e-12, 1.);
      compare("  q", point.equivalent_stress() / 1e3, c.new_q / 1e3, 1e-12, 1.);
      compare("  released energy",
              released,
              energy(c.p, c.q) - energy(c.new_p, c.new_q),
              1e-12,
              1.);
    }
}

int
main()
{
  test<2>();
  test<3>();
}
