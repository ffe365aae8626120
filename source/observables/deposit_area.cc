#include <deal.II/base/patterns.h>

#include <mpm_granular/observables/deposit_area.h>
#include <mpm_granular/observables/surface.h>

namespace mpm_granular::Observables
{
  using namespace dealii;

  template <int dim>
  void
  DepositArea<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Area bin width",
      bin_width,
      "Width of the bins along the run-out in which the surface "
      "is looked for when its area is measured; 0 stands for "
      "the mean cell size. Units: m.",
      Patterns::Double(0.));
  }



  template <int dim>
  std::vector<std::string>
  DepositArea<dim>::columns() const
  {
    return {"area"};
  }



  template <int dim>
  std::vector<double>
  DepositArea<dim>::values(const Snapshot<dim> &snapshot,
                           const Frame<dim>    &frame)
  {
    const double width =
      bin_width > 0. ? bin_width : snapshot.mesh.mean_cell_size();
    return {find_surface(snapshot.points, snapshot.communicator, frame, width)
              .area()};
  }



  namespace
  {
    const RegisterObservable<DepositArea>
      entry("deposit area", "Area of the body seen from the side.");
  }

  template class DepositArea<2>;
  template class DepositArea<3>;
} // namespace mpm_granular::Observables
