// Plane strain is the case of 3D without velocity and gradients out of the
// plane: both give the same stress over random paths.

#include "single_point.h"

#include <random>

using namespace Test;

void
test(const std::string &law, const std::vector<std::string> &entries)
{
  std::mt19937 generator(3);
  const auto   random = [&] { return generator() / 2147483648. - 1.; };

  SinglePoint<2> plane(law, entries, pressure_and_shear<2>(1e4, 3e3));
  SinglePoint<3> space(law, entries, pressure_and_shear<3>(1e4, 3e3));
  double         difference = 0., largest_q = 0., out_of_plane = 0.;
  double         released = 0., released_difference = 0.;
  for (unsigned int n = 0; n < 2000; ++n)
    {
      Tensor<2, 2> gradient;
      Tensor<2, 3> same;
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
          gradient[i][j] = same[i][j] = 10. * random();
      const double of_plane = plane.step(gradient, 1e-4);
      const double of_space = space.step(same, 1e-4);
      released += of_plane;
      released_difference =
        std::max(released_difference, std::abs(of_plane - of_space));
      for (unsigned int c = 0; c < 4; ++c)
        difference =
          std::max(difference, std::abs(plane.stress()[c] - space.stress()[c]));
      for (unsigned int c = 4; c < 6; ++c)
        out_of_plane = std::max(out_of_plane, std::abs(space.stress()[c]));
      largest_q = std::max(largest_q, plane.equivalent_stress());
    }
  std::cout << law << (entries.empty() ? "" : ", " + entries[0]) << std::endl;
  compare("  stress", difference / largest_q, 0., 1e-12, 1.);
  compare("  shear out of the plane", out_of_plane, 0., 0., 1.);
  compare("  released energy", released_difference, 0., 1e-12, 1. + released);
}

int
main()
{
  test(elastic, {});
  test(granular, {"Perzyna exponent=1"});
  test(granular, {"Perzyna exponent=2"});
  test(granular, {"Perzyna exponent=0.7"});
  test("Drucker-Prager cohesive", {"Cohesion=1e3", "Dilatancy angle=5"});
  test("Mohr-Coulomb", {"Dilatancy angle=5"});
  test("Mohr-Coulomb", {"Flow=rate-independent", "Cohesion=1e3"});
  test("mu(I)", {});
}
