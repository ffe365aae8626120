#include <mpm_granular/core/vectorize.h>
#include <mpm_granular/materials/linear_elastic.h>
#include <mpm_granular/materials/stress_columns.h>
#include <mpm_granular/parameters/pattern_text.h>

namespace mpm_granular::Materials
{
  using namespace dealii;

  template <int dim>
  void
  LinearElastic<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Density",
                      initial_density,
                      "Mass per volume at zero stress. Units: kg/m^3.",
                      Parameters::positive_number());
    moduli.add_parameters(prm);
  }



  template <int dim>
  void
  LinearElastic<dim>::check() const
  {
    moduli.check();
  }



  template <int dim>
  void
  LinearElastic<dim>::initialize(Points::PointArrays<dim> &,
                                 const Points::Run) const
  {}



  template <int dim>
  double
  LinearElastic<dim>::update(Points::PointArrays<dim>    &points,
                             const Points::Run            batch,
                             const StrainIncrements<dim> &increments) const
  {
    const unsigned int n_points = batch.end - batch.begin;
    const double       bulk = moduli.bulk(), shear = moduli.shear();
    StressColumns<dim> stress(points, batch.begin);

    MPM_INDEPENDENT_ITERATIONS
    for (unsigned int i = 0; i < n_points; ++i)
      {
        const Stress<dim> old = stress.load(i);
        stress.store(i,
                     increments.trial_deviator(deviator(old), shear, i),
                     pressure(old) - bulk * increments.log_volume_ratio[i]);
      }
    return 0.;
  }

  template class LinearElastic<2>;
  template class LinearElastic<3>;

  namespace
  {
    const std::string documentation =
      "elasticity with the Jaumann rate of the stress, without yield.";
    const LawRegistry<2>::Entry<LinearElastic<2>> elastic_2d("linear elastic",
                                                             documentation);
    const LawRegistry<3>::Entry<LinearElastic<3>> elastic_3d("linear elastic",
                                                             documentation);
  } // namespace
} // namespace mpm_granular::Materials
