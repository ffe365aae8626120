#ifndef mpm_granular_materials_elastic_moduli_h
#define mpm_granular_materials_elastic_moduli_h

#include <deal.II/base/parameter_handler.h>

#include <mpm_granular/materials/deviator.h>

namespace mpm_granular::Materials
{
  /// Isotropic elasticity (T4), read as Young modulus and Poisson ratio.
  class ElasticModuli
  {
  public:
    ElasticModuli();

    /// Declares and binds 'Young modulus' and 'Poisson ratio'.
    void
    add_parameters(dealii::ParameterHandler &prm);

    /// Throws InputError at the ends of the range of Poisson's ratio, where a
    /// modulus is zero or infinite.
    void
    check() const;

    /// K = E / (3 (1 - 2 nu)) (T4) [Pa].
    double
    bulk() const
    {
      return bulk_modulus;
    }

    /// G = E / (2 (1 + nu)) (T4) [Pa].
    double
    shear() const
    {
      return shear_modulus;
    }

    /// Elastic energy per volume, p^2/(2K) + q^2/(6G) (T28) [J/m^3].
    template <typename StressType>
    double
    energy_density(const StressType &stress) const
    {
      const double p = pressure(stress);
      return p * p / (2. * bulk_modulus) +
             equivalent_stress_square(deviator(stress)) / (6. * shear_modulus);
    }

  private:
    /// From the entries; called whenever one of them is set.
    void
    set_moduli();

    double young_modulus = 1e6;
    double poisson_ratio = 0.3;
    double bulk_modulus;
    double shear_modulus;
  };
} // namespace mpm_granular::Materials

#endif
