#include <deal.II/base/patterns.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/core/vectorize.h>
#include <mpm_granular/materials/mu_of_i.h>
#include <mpm_granular/parameters/pattern_text.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace mpm_granular::Materials
{
  using namespace dealii;

  template <int dim>
  void
  MuOfI<dim>::add_parameters(ParameterHandler &prm)
  {
    using Parameters::positive_number;
    GranularLaw<dim>::add_parameters(prm);
    prm.add_parameter("Static friction",
                      static_friction,
                      "mu_s: shear stress over pressure where flow begins.",
                      positive_number());
    prm.add_parameter("Largest friction",
                      largest_friction,
                      "mu_2: shear stress over pressure in the limit of fast "
                      "flow, more than the static friction.",
                      positive_number());
    prm.add_parameter("Inertial number",
                      inertial_number,
                      "I_0: inertial number at which the friction is half-way "
                      "between both.",
                      positive_number());
    prm.add_parameter("Grain diameter",
                      grain_diameter,
                      "Diameter d of the grains, in the inertial number I = "
                      "rate d sqrt(grain density/pressure). Units: m.",
                      positive_number());
    prm.add_parameter("Grain density",
                      grain_density,
                      "Mass per volume of the grains themselves. Units: "
                      "kg/m^3.",
                      positive_number());
  }



  template <int dim>
  void
  MuOfI<dim>::check() const
  {
    GranularLaw<dim>::check();
    std::ostringstream text;
    if (!(largest_friction > static_friction))
      text << "'Largest friction' must be more than 'Static friction', "
           << static_friction << ". It is " << largest_friction << '.';
    else if (!(grain_density > this->density()))
      text << "'Grain density' must be more than 'Density', " << this->density()
           << " kg/m^3, which has the pores in it. It is " << grain_density
           << '.';
    if (!text.str().empty())
      throw InputError(text.str());
  }



  template <int dim>
  void
  MuOfI<dim>::flow(typename GranularLaw<dim>::Stresses &stresses) const
  {
    const double bulk = this->moduli.bulk(), shear = this->moduli.shear();
    // w / sqrt(p) of (T58b).
    const double viscous = inertial_number /
                           (grain_diameter * std::sqrt(grain_density)) * shear *
                           stresses.time_step;
    constexpr double no_zero_division = 1e-200; // [Pa^2]

    MPM_INDEPENDENT_ITERATIONS
    for (unsigned int i = 0; i < stresses.n_points; ++i)
      {
        const double tau_tr =
          std::sqrt(equivalent_stress_square(stresses.deviator_of(i)) / 3.);
        // In this order of arguments, max() keeps what is not a number.
        const double p       = std::max(stresses.pressure[i], 0.);
        stresses.opening[i]  = (p - stresses.pressure[i]) / bulk;
        stresses.pressure[i] = p;

        const double w        = viscous * std::sqrt(p);
        const double lowest   = static_friction * p;
        const double highest  = largest_friction * p;
        const double sum      = highest + tau_tr + w;
        const double product  = highest * tau_tr + lowest * w;
        const double root     = std::sqrt(sum * sum - 4. * product);
        const double tau      = 2. * product / (sum + root);
        const bool   is_solid = tau_tr <= lowest;
        const double factor =
          is_solid ?
            1. :
            std::min(tau * tau_tr / (tau_tr * tau_tr + no_zero_division), 1.);
        stresses.scale_deviator(i, factor);
      }
  }



  template <int dim>
  double
  MuOfI<dim>::mobilization(const Stress<dim> &stress) const
  {
    const double p = pressure(stress);
    const double q = equivalent_stress(stress);
    if (p < 0.)
      return std::numeric_limits<double>::infinity();
    return q > 0. ? q / (std::sqrt(3.) * static_friction * p) : 0.;
  }

  template class MuOfI<2>;
  template class MuOfI<3>;

  namespace
  {
    const std::string documentation =
      "the mu(I) rheology: friction that grows with the inertial number of the "
      "flow, elastic below yield, separating without tension.";
    const LawRegistry<2>::Entry<MuOfI<2>> mu_of_i_2d("mu(I)", documentation);
    const LawRegistry<3>::Entry<MuOfI<3>> mu_of_i_3d("mu(I)", documentation);
  } // namespace
} // namespace mpm_granular::Materials
