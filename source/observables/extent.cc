#include <deal.II/base/patterns.h>

#include <mpm_granular/observables/extent.h>
#include <mpm_granular/parameters/documentation_handler.h>

#include <cmath>

namespace mpm_granular::Observables
{
  using namespace dealii;

  template <int dim>
  void
  Extent<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Mass fraction",
                      mass_fraction,
                      "Share of the mass that lies below the front, and below "
                      "the height. Units: none.",
                      Patterns::Double(0.5, 1.));
    prm.add_parameter("Height of",
                      height_of,
                      "Which points the height is taken of: all of them, or "
                      "those of a column at a place along the run-out.",
                      Patterns::Selection("all points|column"));
    Parameters::only_with(prm, "Height of", "column", height_of, [&] {
      prm.add_parameter("Column position",
                        column_position,
                        "Coordinate of the column along the run-out. "
                        "Units: m.");
      prm.add_parameter("Column reach",
                        column_reach,
                        "Distance from the column's position, to both sides, "
                        "up to which points belong to it; 0 stands for the "
                        "mean cell size. Units: m.",
                        Patterns::Double(0.));
    });
  }



  template <int dim>
  std::vector<std::string>
  Extent<dim>::columns() const
  {
    return {"front", "height"};
  }



  template <int dim>
  Slab<dim>
  Extent<dim>::column(const Snapshot<dim> &snapshot,
                      const Frame<dim>    &frame) const
  {
    if (height_of != "column")
      return {};
    const double reach =
      column_reach > 0. ? column_reach : snapshot.mesh.mean_cell_size();
    return {frame.along, column_position - reach, column_position + reach};
  }



  template <int dim>
  std::vector<double>
  Extent<dim>::values(const Snapshot<dim> &snapshot, const Frame<dim> &frame)
  {
    const double front = mass_quantile(snapshot.points,
                                       snapshot.communicator,
                                       frame.along,
                                       mass_fraction);
    const double top   = mass_quantile(snapshot.points,
                                     snapshot.communicator,
                                     frame.up,
                                     mass_fraction,
                                     column(snapshot, frame));
    // A column without points has no height.
    return {front, std::isnan(top) ? 0. : top - frame.floor};
  }



  namespace
  {
    const RegisterObservable<Extent> entry("extent", "Front and height.");
  }

  template class Extent<2>;
  template class Extent<3>;
} // namespace mpm_granular::Observables
