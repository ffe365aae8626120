// The entries of the laws: values that are refused, with the entry and what is
// allowed; what follows from the values; remarks on initial stresses.

#include "single_point.h"

#include <mpm_granular/materials/drucker_prager_viscoplastic.h>

using namespace Test;

void
expect_refusal(const std::string &law, const std::vector<std::string> &entries)
{
  try
    {
      make_law<3>(law, entries);
      std::cout << entries.back() << " was accepted" << std::endl;
    }
  catch (const InputError &error)
    {
      std::cout << error.what() << std::endl;
    }
}

void
expect_unknown(const std::string &law, const std::string &entry)
{
  try
    {
      make_law<3>(law, {entry});
      std::cout << entry << " was accepted" << std::endl;
    }
  catch (const InputError &)
    {
      std::cout << law << " refuses " << entry << std::endl;
    }
}

/// m for each rule at 30 degrees, S = 1/2.
void
test_slopes()
{
  const double S = .5;
  for (const auto &[rule, expected] :
       {std::make_pair("paper", 36. / 35.),
        std::make_pair("triaxial compression", 6. * S / (3. - S)),
        std::make_pair("triaxial extension", 6. * S / (3. + S)),
        std::make_pair("plane strain", std::sqrt(3.) * S)})
    {
      Materials::DruckerPragerViscoplastic<2> law;
      Parameters::read(
        law, "", {"Friction angle=30", std::string("Cone slope=") + rule});
      compare(std::string("m, ") + rule, law.cone_slope(), expected, 1e-14);
    }
  // 18 sin/(9 - sin^2) at 20 and 40 degrees.
  for (const auto &[angle, expected] :
       {std::make_pair("20", 0.69305), std::make_pair("40", 1.34743)})
    {
      Materials::DruckerPragerViscoplastic<3> law;
      Parameters::read(law, "", {std::string("Friction angle=") + angle});
      compare(std::string("m at ") + angle + " degrees",
              law.cone_slope(),
              expected,
              1e-5);
    }
}

template <int dim>
void
test_values(const std::string &name)
{
  const auto law =
    make_law<dim>(name,
                  {"Density=1700", "Young modulus=2e6", "Poisson ratio=0.2"});
  std::cout << name << ", " << dim << "D" << std::endl;
  compare("  density", law->density(), 1700., 0.);
  compare("  K, MPa", law->bulk_modulus() / 1e6, 2. / 1.8, 1e-14);
  compare("  G, MPa", law->shear_modulus() / 1e6, 2. / 2.4, 1e-14);
  // p = 4 kPa; s = (-2, 1, 1) kPa and shear 3 kPa: q^2 = 9 + 27 kPa^2.
  Stress<dim> stress{{-6e3, -3e3, -3e3, 3e3}};
  compare("  elastic energy density, J/m^3",
          law->elastic_energy_density(stress),
          16e6 / (2. * 2e6 / 1.8) + 36e6 / (6. * 2e6 / 2.4),
          1e-14);
  for (const auto &slot : law->history_names())
    std::cout << "  history: " << slot << std::endl;
}

/// The history belongs to the stress: a step without strain changes nothing.
template <int dim>
void
test_initial_state()
{
  const Stress<dim> stress{{-7e3, -8e3, -9e3, 1e3}};
  SinglePoint<dim>  point(granular, {}, stress);
  compare("ln J_s of p = 8 kPa", point.history(1), -8e3 * 1.2 / 1e6, 1e-14);
  compare("viscoplastic strain", point.history(0), 0., 0., 1.);
  const double released = point.step(Tensor<2, dim>(), 1e-3);
  compare("energy released at rest", released, 0., 0., 1.);
  for (unsigned int c = 0; c < n_stress<dim>; ++c)
    compare("stress, kPa", point.stress()[c] / 1e3, stress[c] / 1e3, 1e-14, 1.);
  point.set_stress({{1e3, 1e3, 1e3}});
  compare("ln J_s of tension", point.history(1), 0., 0., 1.);
}

void
test_remarks()
{
  const auto law = make_law<3>(granular);
  for (const double K0 : {.3, .38, .39, 1., 4.2, 4.3})
    std::cout << "K0 = " << K0 << ": \""
              << law->remark_on({{K0 * -1e4, K0 * -1e4, -1e4}}) << '"'
              << std::endl;
  std::cout << "tension: \"" << law->remark_on({{10., 10., 10.}}) << '"'
            << std::endl;
  for (const std::string law :
       {"Drucker-Prager cohesive", "Mohr-Coulomb", "mu(I)"})
    for (const double stress : {-3e4, -5e3, -1e3, 10.})
      std::cout << law << ", " << stress << ": \""
                << make_law<3>(law)->remark_on({{-1e4, -1e4, stress}}) << '"'
                << std::endl;
  std::cout << "no stress: \"" << law->remark_on({}) << '"' << std::endl;
  std::cout << "elastic: \"" << make_law<3>(elastic)->remark_on({{10.}}) << '"'
            << std::endl;
}

int
main()
{
  for (const std::string entry : {"Density=0",
                                  "Young modulus=-1",
                                  "Poisson ratio=0.5",
                                  "Poisson ratio=-1",
                                  "Poisson ratio=0.6",
                                  "Friction angle=0",
                                  "Friction angle=90",
                                  "Cone slope=mean",
                                  "Fluidity=0",
                                  "Perzyna exponent=0",
                                  "Perzyna exponent=101",
                                  "Separation=tracked"})
    expect_refusal(granular, {entry});
  expect_refusal(granular, {"Separation=capped", "Log volume ratio cap=0"});
  expect_refusal(elastic, {"Poisson ratio=0.5"});
  for (const std::string law : {"Drucker-Prager cohesive", "Mohr-Coulomb"})
    {
      expect_refusal(law, {"Cohesion=-1"});
      expect_refusal(law, {"Friction angle=25", "Dilatancy angle=26"});
      expect_refusal(law, {"Cohesion=1e3", "Tensile strength=1733"});
      expect_refusal(law, {"Flow=plastic"});
      expect_unknown(law, "Log volume ratio cap=0.1");
    }
  expect_refusal("mu(I)", {"Static friction=0.5", "Largest friction=0.5"});
  expect_refusal("mu(I)", {"Density=1500", "Grain density=1500"});
  expect_refusal("mu(I)", {"Grain diameter=0"});
  // Entries without effect: the messages are tested with the parameters.
  expect_unknown(granular, "Log volume ratio cap=0.1");
  expect_unknown(elastic, "Friction angle=30");

  test_slopes();
  test_values<2>(elastic);
  test_values<3>(granular);
  test_initial_state<2>();
  test_initial_state<3>();
  test_remarks();
}
