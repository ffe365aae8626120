#include <mpm_granular/core/vectorize.h>
#include <mpm_granular/materials/granular_law.h>
#include <mpm_granular/materials/pressure_replacement.h>
#include <mpm_granular/materials/stress_columns.h>
#include <mpm_granular/parameters/pattern_text.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace mpm_granular::Materials
{
  using namespace dealii;

  template <int dim>
  void
  GranularLaw<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Density",
                      initial_density,
                      "Mass per volume, pores included, at zero stress. Units: "
                      "kg/m^3.",
                      Parameters::positive_number());
    moduli.add_parameters(prm);
    separation.add_parameters(prm);
  }



  template <int dim>
  void
  GranularLaw<dim>::check() const
  {
    moduli.check();
  }



  template <int dim>
  void
  GranularLaw<dim>::initialize(Points::PointArrays<dim> &points,
                               const Points::Run         run) const
  {
    for (const auto slot : {equivalent_viscoplastic_strain, gap})
      std::fill(points.history[slot].begin() + run.begin,
                points.history[slot].begin() + run.end,
                0.);
  }



  template <int dim>
  double
  GranularLaw<dim>::update(Points::PointArrays<dim>    &points,
                           const Points::Run            batch,
                           const StrainIncrements<dim> &increments) const
  {
    const double  bulk = moduli.bulk(), shear = moduli.shear();
    const double  largest_gap = separation.largest_gap();
    const double *volume      = points.volume.data() + batch.begin;
    double       *strain =
      points.history[equivalent_viscoplastic_strain].data() + batch.begin;
    double            *gap_of = points.history[gap].data() + batch.begin;
    StressColumns<dim> stress(points, batch.begin);

    Stresses stresses;
    stresses.n_points  = batch.end - batch.begin;
    stresses.time_step = increments.time_step;
    alignas(64) std::array<typename Stresses::Column, n_stress<dim>> trial;
    alignas(64) typename Stresses::Column old_pressure, trial_pressure;
    alignas(64) typename Stresses::Column released;

    MPM_INDEPENDENT_ITERATIONS
    for (unsigned int i = 0; i < stresses.n_points; ++i)
      {
        const Stress<dim> old = stress.load(i);
        const Stress<dim> deviator_tr =
          increments.trial_deviator(deviator(old), shear, i);
        for (unsigned int c = 0; c < n_stress<dim>; ++c)
          trial[c][i] = stresses.deviator[c][i] = deviator_tr[c];

        // A gap closes before there is pressure (T50). In this order of
        // arguments, max() and min() keep what is not a number.
        old_pressure[i] = pressure(old);
        const double without_gap =
          old_pressure[i] - bulk * increments.log_volume_ratio[i];
        const double closing =
          std::min(std::max(without_gap, 0.) / bulk, gap_of[i]);
        gap_of[i] -= closing;
        trial_pressure[i]    = without_gap - bulk * closing;
        stresses.pressure[i] = trial_pressure[i];
        stresses.opening[i]  = 0.;
      }

    flow(stresses);

    MPM_INDEPENDENT_ITERATIONS
    for (unsigned int i = 0; i < stresses.n_points; ++i)
      {
        // The mean stress of the step on the inelastic strain (T52); the old
        // deviator, rotated, is the trial without the elastic strain.
        Stress<dim> mean, flowed;
        for (unsigned int c = 0; c < n_stress<dim>; ++c)
          {
            mean[c] = .5 * (trial[c][i] + stresses.deviator[c][i]) -
                      shear * increments.deviatoric_strain[c][i];
            flowed[c] = (trial[c][i] - stresses.deviator[c][i]) / (2. * shear);
          }
        double product = 0.;
        for (unsigned int c = 0; c < n_stress<dim>; ++c)
          product += (c < 3 ? 1. : 2.) * mean[c] * flowed[c];

        const double new_pressure = stresses.pressure[i];
        const double opening      = stresses.opening[i];
        const double dilation =
          (new_pressure - trial_pressure[i]) / bulk - opening;
        released[i] =
          volume[i] *
          (product - .5 * (old_pressure[i] + new_pressure) * dilation -
           new_pressure * opening);

        // sqrt(2/3 e:e), with the q of the tensor e: q^2 = 3/2 e:e.
        strain[i] += (2. / 3.) * std::sqrt(equivalent_stress_square(flowed));
        gap_of[i] = std::min(gap_of[i] + opening, largest_gap);
        stress.store(i, stresses.deviator_of(i), new_pressure);
      }
    return std::accumulate(released.begin(),
                           released.begin() + stresses.n_points,
                           0.);
  }



  template <int dim>
  double
  GranularLaw<dim>::replace_pressure(Points::PointArrays<dim> &points,
                                     const Points::Run         run,
                                     const double             *target) const
  {
    return Materials::replace_pressure(
      points, run, target, apex_tension(), moduli);
  }



  template <int dim>
  void
  GranularLaw<dim>::reconcile(Points::PointArrays<dim> &points,
                              const Points::Run         run) const
  {
    StressColumns<dim> stress(points, 0);
    for (unsigned int i = run.begin; i < run.end; ++i)
      {
        const Stress<dim> old          = stress.load(i);
        const double      old_pressure = pressure(old);
        double           &gap_of_point = points.history[gap][i];
        const double      closing =
          std::min(std::max(old_pressure, 0.) / moduli.bulk(), gap_of_point);
        if (closing == 0.)
          continue;
        gap_of_point -= closing;
        const double new_pressure = old_pressure - moduli.bulk() * closing;
        Stress<dim>  scaled       = deviator(old);
        for (double &component : scaled)
          component *=
            (new_pressure + apex_tension()) / (old_pressure + apex_tension());
        stress.store(i, scaled, new_pressure);
      }
  }



  template <int dim>
  std::string
  GranularLaw<dim>::remark_on(const Stress<dim> &initial_stress) const
  {
    const double mobilized = mobilization(initial_stress);
    if (!(mobilized > 1. + 1e-10))
      return {};
    std::ostringstream text;
    text << "The initial stress is outside of the yield surface: ";
    if (std::isinf(mobilized))
      text << "the material does not bear its tension";
    else
      text << mobilized << " times the strength";
    text << ". It will flow at once.";
    return text.str();
  }

  template class GranularLaw<2>;
  template class GranularLaw<3>;
} // namespace mpm_granular::Materials
