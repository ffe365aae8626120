#include <deal.II/base/patterns.h>

#include <mpm_granular/output/number_text.h>
#include <mpm_granular/parameters/documentation_handler.h>
#include <mpm_granular/parameters/pattern_text.h>
#include <mpm_granular/solver/initial_equilibrium.h>

namespace mpm_granular::Solver
{
  using namespace dealii;

  std::string
  Unrest::text() const
  {
    return "forces out of balance " + Output::short_text(force_ratio) +
           " of weights or internal forces, kinetic energy " +
           Output::short_text(energy_ratio) + " of the elastic one";
  }

  template <int dim>
  void
  InitialEquilibrium<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Enabled",
                      is_wanted,
                      "Whether stresses in equilibrium with gravity and the "
                      "loads of time 0 are found before the start. Points stay "
                      "where they were filled; the rows of the stage have "
                      "negative times.");
    const std::string value = is_wanted ? "true" : "false";
    Parameters::only_with(prm, "Enabled", "true", value, [&] {
      prm.add_parameter("Force tolerance",
                        force_tolerance,
                        "Largest norm of the nodal forces out of balance over "
                        "that of the weights or internal forces. Units: -.",
                        Parameters::positive_number());
      prm.add_parameter("Energy tolerance",
                        energy_tolerance,
                        "Largest kinetic over elastic energy. Units: -.",
                        Parameters::positive_number());
      prm.add_parameter(
        "Maximum time",
        maximum_time,
        "The stage lasts that long at most; the run ends with "
        "exit code 2 if there is no equilibrium then. Units: s.",
        Parameters::positive_number());
      damping.add_parameters(prm);
    });
  }

  template <int dim>
  bool
  InitialEquilibrium<dim>::is_reached(const Unrest &unrest) const
  {
    return unrest.force_ratio <= force_tolerance &&
           unrest.energy_ratio <= energy_tolerance;
  }

  template struct InitialEquilibrium<2>;
  template struct InitialEquilibrium<3>;
} // namespace mpm_granular::Solver
