#include <deal.II/base/symmetric_tensor.h>

#include <mpm_granular/materials/mohr_coulomb.h>
#include <mpm_granular/materials/mohr_coulomb_return.h>

#include <cmath>
#include <limits>

namespace mpm_granular::Materials
{
  using namespace dealii;

  namespace
  {
    /// Principal values in descending order with their directions; in plane
    /// strain one is out of the plane. By Jacobi's rotations, which are exact
    /// to round-off also for equal values.
    template <std::size_t n_components>
    std::array<std::pair<double, Tensor<1, 3>>, 3>
    principal_directions(const std::array<double, n_components> &stress)
    {
      SymmetricTensor<2, 3> tensor;
      for (unsigned int c = 0; c < n_components; ++c)
        tensor[stress_index[c][0]][stress_index[c][1]] = stress[c];
      return eigenvectors(tensor, SymmetricTensorEigenvectorMethod::jacobi);
    }
  } // namespace



  template <int dim>
  void
  MohrCoulomb<dim>::add_parameters(ParameterHandler &prm)
  {
    GranularLaw<dim>::add_parameters(prm);
    strength.add_parameters(prm);
    perzyna.add_parameters(prm);
  }



  template <int dim>
  void
  MohrCoulomb<dim>::check() const
  {
    GranularLaw<dim>::check();
    strength.check();
  }



  template <int dim>
  void
  MohrCoulomb<dim>::flow(typename GranularLaw<dim>::Stresses &stresses) const
  {
    const PerzynaStep          step = perzyna.over(stresses.time_step);
    const MohrCoulombConstants constants(strength, this->moduli);
    for (unsigned int i = 0; i < stresses.n_points; ++i)
      {
        const auto   trial    = stresses.deviator_of(i);
        double      &pressure = stresses.pressure[i];
        const double old      = pressure;
        if (!std::isfinite(equivalent_stress_square(trial)))
          continue;
        const auto      directions = principal_directions(trial);
        PrincipalStress sigma;
        for (unsigned int k = 0; k < 3; ++k)
          sigma[k] = directions[k].first - old;
        const PrincipalStress result =
          return_to_mohr_coulomb(sigma, constants, step);
        if (result == sigma)
          continue;

        pressure = -(result[0] + result[1] + result[2]) / 3.;
        for (unsigned int c = 0; c < n_stress<dim>; ++c)
          {
            const auto [row, column] = stress_index[c];
            stresses.deviator[c][i]  = 0.;
            for (unsigned int k = 0; k < 3; ++k)
              stresses.deviator[c][i] += (result[k] + pressure) *
                                         directions[k].second[row] *
                                         directions[k].second[column];
          }
        if (result[2] >= constants.tension) // on all sides
          stresses.opening[i] = (pressure - old) / constants.bulk;
      }
  }



  template <int dim>
  double
  MohrCoulomb<dim>::mobilization(const Stress<dim> &stress) const
  {
    const MohrCoulombConstants constants(strength, this->moduli);
    const auto                 directions = principal_directions(stress);
    const PrincipalStress      sigma{
      {directions[0].first, directions[1].first, directions[2].first}};
    const double difference = constants.stress(sigma);
    if (sigma[0] > constants.tension + 1e-10 * std::abs(sigma[2]))
      return std::numeric_limits<double>::infinity();
    return difference > 0. ? difference / constants.strength(sigma) : 0.;
  }

  template class MohrCoulomb<2>;
  template class MohrCoulomb<3>;

  namespace
  {
    const std::string documentation =
      "the pyramid of Mohr and Coulomb with cohesion, dilatancy and tension "
      "cut-off, Perzyna's flow or rate-independent.";
    const LawRegistry<2>::Entry<MohrCoulomb<2>> mohr_coulomb_2d("Mohr-Coulomb",
                                                                documentation);
    const LawRegistry<3>::Entry<MohrCoulomb<3>> mohr_coulomb_3d("Mohr-Coulomb",
                                                                documentation);
  } // namespace
} // namespace mpm_granular::Materials
