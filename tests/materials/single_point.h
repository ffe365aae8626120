#ifndef tests_materials_single_point_h
#define tests_materials_single_point_h

#include <mpm_granular/materials/stress_update.h>
#include <mpm_granular/parameters/parameter_file.h>

#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

namespace Test
{
  using namespace dealii;
  using namespace mpm_granular;

  /// A law with some of its entries ("Entry=value").
  template <int dim>
  std::unique_ptr<Materials::ConstitutiveLaw<dim>>
  make_law(const std::string              &name,
           const std::vector<std::string> &entries = {})
  {
    auto law = Materials::LawRegistry<dim>::make(name);
    Parameters::read(*law, "", entries);
    law->check();
    return law;
  }

  const std::string granular = "Drucker-Prager viscoplastic";
  const std::string elastic  = "linear elastic";

  /// One material point of volume 1 that is strained as a test says.
  template <int dim>
  class SinglePoint
  {
  public:
    SinglePoint(const std::string              &law_name,
                const std::vector<std::string> &entries,
                const Stress<dim>              &initial_stress)
      : law(make_law<dim>(law_name, entries))
    {
      points.resize(1, law->history_names().size());
      points.volume[0] = 1.;
      set_stress(initial_stress);
    }

    void
    set_stress(const Stress<dim> &stress)
    {
      for (unsigned int c = 0; c < n_stress<dim>; ++c)
        points.stress[c][0] = stress[c];
      law->initialize(points, {0, 1});
    }

    /// A step with velocity gradient @p gradient. @return released energy.
    double
    step(const Tensor<2, dim> &gradient, const double time_step)
    {
      const Points::Run run{0, 1};
      return Materials::update_stress<dim>(*law,
                                           points,
                                           make_array_view(&run, &run + 1),
                                           make_array_view(&gradient,
                                                           &gradient + 1),
                                           time_step);
    }

    Stress<dim>
    stress() const
    {
      Stress<dim> result;
      for (unsigned int c = 0; c < n_stress<dim>; ++c)
        result[c] = points.stress[c][0];
      return result;
    }

    /// -tr(sigma)/3, as the theory says, not as the code computes it.
    double
    pressure() const
    {
      const auto sigma = stress();
      return -(sigma[0] + sigma[1] + sigma[2]) / 3.;
    }

    /// sqrt(3/2 s:s) by differences of normal stresses.
    double
    equivalent_stress() const
    {
      const auto sigma = stress();
      double     sum   = .5 * (std::pow(sigma[0] - sigma[1], 2) +
                         std::pow(sigma[1] - sigma[2], 2) +
                         std::pow(sigma[2] - sigma[0], 2));
      for (unsigned int c = 3; c < n_stress<dim>; ++c)
        sum += 3. * sigma[c] * sigma[c];
      return std::sqrt(sum);
    }

    double
    history(const unsigned int slot) const
    {
      return points.history[slot][0];
    }

    double
    volume() const
    {
      return points.volume[0];
    }

    Points::PointArrays<dim>                         points;
    std::unique_ptr<Materials::ConstitutiveLaw<dim>> law;
  };



  /// A stress with pressure p and the shear stress xy.
  template <int dim>
  Stress<dim>
  pressure_and_shear(const double p, const double shear)
  {
    Stress<dim> stress{};
    stress[0] = stress[1] = stress[2] = -p;
    stress[3]                         = shear;
    return stress;
  }



  /// Simple shear v_x = rate y.
  template <int dim>
  Tensor<2, dim>
  simple_shear(const double rate)
  {
    Tensor<2, dim> gradient;
    gradient[0][1] = rate;
    return gradient;
  }



  /// Prints @p value and whether it is within @p tolerance, relative to
  /// @p scale, of what it should be.
  inline void
  compare(const std::string &what,
          const double       value,
          const double       expected,
          const double       tolerance,
          const double       scale)
  {
    const bool agrees = std::abs(value - expected) <= tolerance * scale;
    std::cout << what << ": " << std::setprecision(5) << expected
              << (agrees ? ", agrees" : ", but it is ");
    if (!agrees)
      std::cout << std::setprecision(12) << value;
    std::cout << std::endl;
  }

  inline void
  compare(const std::string &what,
          const double       value,
          const double       expected,
          const double       tolerance)
  {
    compare(what, value, expected, tolerance, std::abs(expected));
  }



  /// Prints whether the errors of a sequence with halved steps fall with the
  /// power @p order, to @p tolerance in the last exponent.
  inline void
  compare_order(const std::string         &what,
                const std::vector<double> &errors,
                const double               order,
                const double               tolerance)
  {
    const double observed =
      std::log2(std::abs(errors[errors.size() - 2] / errors.back()));
    std::cout << what << ": order " << order
              << (std::abs(observed - order) <= tolerance ? ", agrees" :
                                                            ", but it is ");
    if (!(std::abs(observed - order) <= tolerance))
      std::cout << observed << " with last error " << errors.back();
    std::cout << std::endl;
  }
} // namespace Test

#endif
