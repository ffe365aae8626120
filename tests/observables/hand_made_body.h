#ifndef tests_observables_hand_made_body_h
#define tests_observables_hand_made_body_h

#include "../box_mesh.h"

#include <mpm_granular/materials/constitutive_law.h>
#include <mpm_granular/mesh/background_mesh.h>
#include <mpm_granular/observables/snapshot.h>
#include <mpm_granular/points/point_arrays.h>

#include <string>
#include <vector>

namespace Test
{
  using namespace dealii;
  using namespace mpm_granular;

  /// A law that does nothing; its elastic energy is easily computed by hand.
  template <int dim>
  class SimpleLaw : public Materials::ConstitutiveLaw<dim>
  {
  public:
    SimpleLaw(const double rho, const std::vector<std::string> &names = {})
      : rho(rho)
      , names(names)
    {}

    void
    add_parameters(ParameterHandler &) override
    {}

    void
    check() const override
    {}

    std::vector<std::string>
    history_names() const override
    {
      return names;
    }

    double
    density() const override
    {
      return rho;
    }

    double
    bulk_modulus() const override
    {
      return 1.;
    }

    double
    shear_modulus() const override
    {
      return 1.;
    }

    void
    initialize(Points::PointArrays<dim> &, const Points::Run) const override
    {}

    double
    update(Points::PointArrays<dim> &,
           const Points::Run,
           const Materials::StrainIncrements<dim> &) const override
    {
      return 0.;
    }

    /// The sum of the stress components, over the density.
    double
    elastic_energy_density(const Stress<dim> &stress) const override
    {
      double sum = 0.;
      for (const double component : stress)
        sum += component;
      return sum / rho;
    }

  private:
    const double                   rho;
    const std::vector<std::string> names;
  };

  /// Points with all that an observable needs beside them.
  template <int dim>
  struct Body
  {
    Body(const Point<dim>                &lower,
         const Point<dim>                &upper,
         const std::vector<unsigned int> &subdivisions,
         const Tensor<1, dim>            &gravity = {})
      : mesh(BoxMesh<dim>("simplices", subdivisions, lower, upper), "")
      , gravity(gravity)
    {}

    /// Appends a point with zero velocity, stress and material; returns its
    /// index.
    std::size_t
    add(const Point<dim> &x, const double mass, const double volume)
    {
      points.for_each_array([](auto &array) { array.push_back(0); });
      const std::size_t i = points.size() - 1;
      for (unsigned int d = 0; d < dim; ++d)
        points.position[d][i] = x[d];
      points.mass[i]   = mass;
      points.volume[i] = volume;
      points.id[i]     = i;
      return i;
    }

    Observables::Snapshot<dim>
    snapshot() const
    {
      return {
        time, 7, 0.25, 3, gravity, points, mesh, laws, ledger, MPI_COMM_SELF};
    }

    Mesh::BackgroundMesh<dim>                            mesh;
    Tensor<1, dim>                                       gravity;
    Points::PointArrays<dim>                             points;
    std::vector<const Materials::ConstitutiveLaw<dim> *> laws;
    Observables::EnergyLedger                            ledger;
    double                                               time = 0.;
  };
} // namespace Test

#endif
