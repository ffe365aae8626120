#include <mpm_granular/core/vectorize.h>
#include <mpm_granular/materials/drucker_prager_viscoplastic.h>
#include <mpm_granular/materials/pressure_replacement.h>
#include <mpm_granular/materials/return_mapping.h>
#include <mpm_granular/materials/stress_columns.h>

#include <array>
#include <cmath>
#include <numeric>
#include <sstream>

namespace mpm_granular::Materials
{
  using namespace dealii;

  /**
   * What the three passes of update() over a batch hand on. Three, because the
   * one in the middle is a scalar iteration unless the exponent is 1; the other
   * two are vectorized in any case.
   */
  template <int dim>
  struct DruckerPragerViscoplastic<dim>::Trial
  {
    using Column = std::array<double, StrainIncrements<dim>::capacity>;

    alignas(64) Column equivalent_stress; ///< q_tr [Pa]
    alignas(64) Column increment_product; ///< 2 G dt e : s_tr [Pa^2]
    alignas(64) Column pressure;          ///< p at the end of the step [Pa]
    alignas(64) Column factor;            ///< q / q_tr [-]
    alignas(64) Column released_energy;   ///< [J]
  };



  namespace
  {
    /// The sum of the first entries, several partial sums at a time. Overwrites
    /// what follows them.
    template <std::size_t size>
    double
    sum_of_first(const unsigned int n_entries, std::array<double, size> &column)
    {
      constexpr unsigned int n_sums = 8;
      static_assert(size % n_sums == 0);
      for (unsigned int i = n_entries; i % n_sums != 0; ++i)
        column[i] = 0.;
      std::array<double, n_sums> sums{};
      for (unsigned int i = 0; i < n_entries; i += n_sums)
        for (unsigned int k = 0; k < n_sums; ++k)
          sums[k] += column[i + k];
      return std::accumulate(sums.begin(), sums.end(), 0.);
    }
  } // namespace



  template <int dim>
  double
  DruckerPragerViscoplastic<dim>::update(
    Points::PointArrays<dim>    &points,
    const Points::Run            batch,
    const StrainIncrements<dim> &increments) const
  {
    Trial trial;
    predict(points, batch, increments, trial);
    find_factors(batch.end - batch.begin, increments.time_step, trial);
    return correct(points, batch, trial);
  }



  template <int dim>
  void
  DruckerPragerViscoplastic<dim>::predict(
    Points::PointArrays<dim>    &points,
    const Points::Run            batch,
    const StrainIncrements<dim> &increments,
    Trial                       &trial) const
  {
    const double bulk    = parameters.moduli().bulk(),
                 shear   = parameters.moduli().shear();
    const double largest = parameters.largest_log_volume_ratio();
    double *log_ratio = points.history[log_volume_ratio].data() + batch.begin;
    StressColumns<dim> stress(points, batch.begin);

    const unsigned int n_points = batch.end - batch.begin;
    MPM_INDEPENDENT_ITERATIONS
    for (unsigned int i = 0; i < n_points; ++i)
      {
        const Stress<dim> deviator_tr =
          increments.trial_deviator(deviator(stress.load(i)), shear, i);
        stress.store(i, deviator_tr, 0.);
        trial.increment_product[i] =
          2. * shear * increments.strain_product(deviator_tr, i);
        trial.equivalent_stress[i] =
          std::sqrt(equivalent_stress_square(deviator_tr));

        log_ratio[i] =
          std::min(log_ratio[i] + increments.log_volume_ratio[i], largest);
        // In this order of arguments, max() keeps what is not a number.
        trial.pressure[i] = std::max(-bulk * log_ratio[i], 0.);
      }
  }



  template <int dim>
  void
  DruckerPragerViscoplastic<dim>::find_factors(const unsigned int n_points,
                                               const double       time_step,
                                               Trial             &trial) const
  {
    const double m = parameters.cone_slope();
    const double flow =
      3. * parameters.moduli().shear() * parameters.fluidity() * time_step;
    const double negligible = 1e-12 * parameters.moduli().shear();
    if (parameters.exponent() == 1.)
      {
        MPM_INDEPENDENT_ITERATIONS
        for (unsigned int i = 0; i < n_points; ++i)
          trial.factor[i] = linear_return_factor(trial.equivalent_stress[i],
                                                 m * trial.pressure[i],
                                                 flow);
      }
    else
      for (unsigned int i = 0; i < n_points; ++i)
        trial.factor[i] = return_factor(trial.equivalent_stress[i],
                                        m * trial.pressure[i],
                                        flow,
                                        parameters.exponent(),
                                        negligible);
  }



  template <int dim>
  double
  DruckerPragerViscoplastic<dim>::correct(Points::PointArrays<dim> &points,
                                          const Points::Run         batch,
                                          Trial                    &trial) const
  {
    const double  inverse_3G = 1. / (3. * parameters.moduli().shear());
    const double  inverse_4G = 0.75 * inverse_3G;
    const double *volume     = points.volume.data() + batch.begin;
    double       *viscoplastic_strain =
      points.history[equivalent_viscoplastic_strain].data() + batch.begin;
    StressColumns<dim> stress(points, batch.begin);

    const unsigned int n_points = batch.end - batch.begin;
    MPM_INDEPENDENT_ITERATIONS
    for (unsigned int i = 0; i < n_points; ++i)
      {
        const double factor = trial.factor[i];
        Stress<dim>  scaled = stress.load(i);
        for (unsigned int c = 0; c < n_stress<dim>; ++c)
          scaled[c] *= factor;
        stress.store(i, scaled, trial.pressure[i]);

        const double equivalent_tr = trial.equivalent_stress[i];
        viscoplastic_strain[i] += equivalent_tr * (1. - factor) * inverse_3G;

        // The mean stress of the step on the viscoplastic strain (T28b).
        trial.released_energy[i] =
          volume[i] * (1. - factor) * inverse_4G *
          ((1. + factor) * (2. / 3.) * equivalent_tr * equivalent_tr -
           trial.increment_product[i]);
      }
    return sum_of_first(n_points, trial.released_energy);
  }



  template <int dim>
  void
  DruckerPragerViscoplastic<dim>::add_parameters(ParameterHandler &prm)
  {
    parameters.add_parameters(prm);
  }



  template <int dim>
  void
  DruckerPragerViscoplastic<dim>::check() const
  {
    parameters.check();
  }



  template <int dim>
  void
  DruckerPragerViscoplastic<dim>::initialize(Points::PointArrays<dim> &points,
                                             const Points::Run run) const
  {
    const StressColumns<dim> stress(points, 0);
    for (unsigned int i = run.begin; i < run.end; ++i)
      {
        points.history[equivalent_viscoplastic_strain][i] = 0.;
        points.history[log_volume_ratio][i] =
          -std::max(pressure(stress.load(i)), 0.) / parameters.moduli().bulk();
      }
  }



  template <int dim>
  double
  DruckerPragerViscoplastic<dim>::replace_pressure(
    Points::PointArrays<dim> &points,
    const Points::Run         run,
    const double             *target) const
  {
    const auto  &moduli = parameters.moduli();
    const double released =
      Materials::replace_pressure(points, run, target, 0., moduli);

    double            *log_ratio = points.history[log_volume_ratio].data();
    StressColumns<dim> stress(points, 0);
    MPM_INDEPENDENT_ITERATIONS
    for (unsigned int i = run.begin; i < run.end; ++i)
      {
        const double closed = -pressure(stress.load(i)) / moduli.bulk();
        log_ratio[i]        = log_ratio[i] < 0. ? closed : log_ratio[i];
      }
    return released;
  }



  template <int dim>
  void
  DruckerPragerViscoplastic<dim>::reconcile(Points::PointArrays<dim> &points,
                                            const Points::Run         run) const
  {
    StressColumns<dim> stress(points, 0);
    for (unsigned int i = run.begin; i < run.end; ++i)
      {
        const Stress<dim> old          = stress.load(i);
        const double      old_pressure = pressure(old);
        const double      new_pressure =
          std::max(-parameters.moduli().bulk() *
                     points.history[log_volume_ratio][i],
                   0.);
        Stress<dim> scaled = deviator(old);
        for (double &component : scaled)
          component *= old_pressure > 0. ? new_pressure / old_pressure : 0.;
        stress.store(i, scaled, new_pressure);
      }
  }



  template <int dim>
  std::string
  DruckerPragerViscoplastic<dim>::remark_on(
    const Stress<dim> &initial_stress) const
  {
    const double       p     = pressure(initial_stress);
    const double       q     = equivalent_stress(initial_stress);
    const double       slope = parameters.cone_slope();
    std::ostringstream text;
    if (p < 0.)
      text << "The initial pressure is negative (" << p
           << " Pa); this material bears no tension.";
    else if (q > slope * p * (1. + 1e-10))
      {
        text << "The initial stress is outside of the yield surface: q/p = "
             << q / p << " > m = " << slope
             << ". It will flow at once. A geostatic stress is inside if K0 is "
                "at least (3 - m)/(3 + 2 m) = "
             << (3. - slope) / (3. + 2. * slope);
        if (slope < 1.5)
          text << " and at most (3 + m)/(3 - 2 m) = "
               << (3. + slope) / (3. - 2. * slope);
        text << '.';
      }
    return text.str();
  }

  template class DruckerPragerViscoplastic<2>;
  template class DruckerPragerViscoplastic<3>;

  namespace
  {
    const std::string documentation =
      "cohesionless granular material with Perzyna's viscoplastic flow on the "
      "cone of Drucker and Prager, separating without tension.";
    const LawRegistry<2>::Entry<DruckerPragerViscoplastic<2>>
      drucker_prager_2d("Drucker-Prager viscoplastic", documentation);
    const LawRegistry<3>::Entry<DruckerPragerViscoplastic<3>>
      drucker_prager_3d("Drucker-Prager viscoplastic", documentation);
  } // namespace
} // namespace mpm_granular::Materials
