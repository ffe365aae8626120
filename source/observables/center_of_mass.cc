#include <deal.II/base/mpi.h>

#include <mpm_granular/observables/center_of_mass.h>

namespace mpm_granular::Observables
{
  using namespace dealii;

  template <int dim>
  std::vector<std::string>
  CenterOfMass<dim>::columns() const
  {
    return {"center_x", "center_y", "center_z"};
  }



  template <int dim>
  std::vector<double>
  CenterOfMass<dim>::values(const Snapshot<dim> &snapshot, const Frame<dim> &)
  {
    const auto         &points = snapshot.points;
    std::vector<double> center(4, 0.); // and the mass
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        center[3] += points.mass[i];
        for (unsigned int d = 0; d < dim; ++d)
          center[d] += points.mass[i] * points.position[d][i];
      }
    Utilities::MPI::sum(center, snapshot.communicator, center);
    return {center[0] / center[3],
            center[1] / center[3],
            center[2] / center[3]};
  }



  namespace
  {
    const RegisterObservable<CenterOfMass> entry("center of mass",
                                                 "The center of mass.");
  }

  template class CenterOfMass<2>;
  template class CenterOfMass<3>;
} // namespace mpm_granular::Observables
