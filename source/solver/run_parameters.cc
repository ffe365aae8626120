#include <mpm_granular/core/exact_text.h>
#include <mpm_granular/parameters/dimension.h>
#include <mpm_granular/solver/run_parameters.h>

#include <algorithm>

namespace mpm_granular::Solver
{
  using namespace dealii;

  namespace
  {
    /// Declares the entries of @p group in a subsection of its own.
    template <class Group>
    void
    add_section(ParameterHandler &prm, const std::string &name, Group &&declare)
    {
      prm.enter_subsection(name);
      declare();
      prm.leave_subsection();
    }

    /// Checks every group, with its name in front of messages.
    template <class Group>
    void
    check_named(const std::string                    &section,
                const Parameters::NamedGroups<Group> &groups)
    {
      for (const auto &name : groups.all_names())
        try
          {
            groups[name].check();
          }
        catch (const InputError &error)
          {
            throw InputError(section + "/" + name + ": " + error.what());
          }
    }
  } // namespace

  template <int dim>
  RunParameters<dim>::RunParameters()
    : mesh("box")
    , materials({"sand"})
    , regions({"body"})
    , boundary_conditions({"walls"})
    , velocity_update("blend")
    , averaging("automatic")
    , damping("none")
  {}

  template <int dim>
  void
  RunParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    Parameters::declare_dimension(prm, dim);
    prm.add_parameter("End time",
                      end_time,
                      "Time to compute. Units: s.",
                      Patterns::Double(0.));

    add_section(prm, "Mesh", [&] {
      mesh.add_parameters(prm,
                          "Source",
                          "Where the background mesh comes from:");
    });
    add_section(prm, "Adaptive mesh", [&] { adaptation.add_parameters(prm); });
    add_section(prm, "Materials", [&] {
      materials.add_parameters(
        prm, "Materials, each with a subsection of its name.");
    });
    add_section(prm, "Points", [&] {
      regions.add_parameters(
        prm,
        "Regions filled with points, each with a subsection "
        "of its name.");
      prm.add_parameter("Remove lost points",
                        remove_lost_points,
                        "Whether points that leave the mesh are removed (and "
                        "counted); otherwise they end the run.");
    });
    add_section(prm, "Initial state", [&] {
      initial_state.add_parameters(prm);
    });
    add_section(prm, "Initial equilibrium", [&] {
      equilibrium.add_parameters(prm);
    });
    add_section(prm, "Boundary conditions", [&] {
      boundary_conditions.add_parameters(
        prm,
        "Conditions, each with a subsection of its name; where they contradict "
        "each other, the one named first holds.");
    });
    add_section(prm, "Body force", [&] { body_force.add_parameters(prm); });
    add_section(prm, "Scheme", [&] {
      transfer.add_parameters(prm);
      velocity_update.add_parameters(
        prm,
        "Velocity update",
        "How points take their velocity from the grid and hand it on:");
      averaging.add_parameters(prm,
                               "Averaging",
                               "How stresses of points become forces of nodes, "
                               "and velocities of nodes gradients at points:");
      position_shift.add_parameters(prm);
      momentum.add_parameters(prm);
    });
    add_section(prm, "Damping", [&] {
      damping.add_parameters(prm,
                             "Type",
                             "Forces on the nodes that bring a body to rest, "
                             "for quasi-static runs:");
    });
    add_section(prm, "Time step", [&] { time_step.add_parameters(prm); });
    add_section(prm, "Parallel", [&] { partition.add_parameters(prm); });
    add_section(prm, "Output", [&] { output.add_parameters(prm); });
    add_section(prm, "Observables", [&] { observables.add_parameters(prm); });
    add_section(prm, "Checkpoint", [&] { checkpoint.add_parameters(prm); });
  }

  template <int dim>
  void
  RunParameters<dim>::check() const
  {
    mesh->check();
    adaptation.check();
    check_named("Materials", materials);
    check_named("Points", regions);
    const auto &known = materials.all_names();
    for (const auto &name : regions.all_names())
      {
        const std::string &material = regions[name].material_name();
        std::string        list;
        for (const auto &valid : known)
          list += (list.empty() ? "" : ", ") + valid;
        require(std::find(known.begin(), known.end(), material) != known.end(),
                "Points/" + name + "/Material = " + material +
                  " is not a material; Materials/Names has: " + list + ".");
      }
    require(
      !regions.all_names().empty(),
      "Points/Names is empty: a run needs at least one region of points.");
    initial_state.check();
    equilibrium.check();
    check_named("Boundary conditions", boundary_conditions);
    body_force.check();
    transfer.check();
    velocity_update->check();
    require(!velocity_update->needs_means_of_gradients() ||
              averaging->filling_of_nodes() != nullptr,
            "Scheme/Velocity update = " + velocity_update.chosen_name() +
              " needs Scheme/Averaging = nodes, or a Scheme/Gradient damping "
              "rate (1000/s for a wall of 2 m): points at the edge of a body "
              "would fly off; given: " +
              averaging.chosen_name() + ", 0/s.");
    require(position_shift.rate(0.) == 0. ||
              averaging->filling_of_nodes() != nullptr,
            "Scheme/Position shift rate needs Scheme/Averaging = nodes (or to "
            "be 0); given: " +
              averaging.chosen_name() + ".");
    momentum.check();
    require(!velocity_update->needs_lumped_mass() ||
              momentum.mass_matrix.chosen_name() == "lumped",
            "Scheme/Velocity update = " + velocity_update.chosen_name() +
              " needs Scheme/Mass matrix = lumped, which is a part of it; "
              "given: " +
              momentum.mass_matrix.chosen_name() + ".");
    require(velocity_update->handles_stress_first() ||
              transfer.stress_order() !=
                Transfer::StressOrder::update_stress_first,
            "Scheme/Velocity update = " + velocity_update.chosen_name() +
              " needs Scheme/Stress order = MUSL or USL: points take over the "
              "gradient of the new velocity; given: USF.");
    if (averaging->reaches_beyond_cells())
      {
        const std::string scheme =
          "Scheme/Averaging = " + averaging.chosen_name();
        require(velocity_update->handles_wide_functions(),
                scheme + " needs another Scheme/Velocity update than " +
                  velocity_update.chosen_name() +
                  ", which is made for functions that end with the cell.");
        require(momentum.mass_matrix.chosen_name() == "lumped",
                scheme + " needs Scheme/Mass matrix = lumped; given: " +
                  momentum.mass_matrix.chosen_name() + ".");
        require(!adaptation.is_wanted(),
                scheme + " is not defined at the hanging nodes of an 'Adaptive "
                         "mesh', whose 'Names' must be empty then.");
      }
    damping->check();
    require(momentum.mass_scaling == 1. || damping->is_active(),
            "Scheme/Mass scaling = " + Core::exact_text(momentum.mass_scaling) +
              " changes every motion; it is for quasi-static runs and needs a "
              "'Damping/Type' other than 'none' (or be 1).");
    time_step.check();
    output.check();
    observables.check();
    checkpoint.check();
  }

  const std::vector<std::string> &
  changeable_on_resume()
  {
    static const std::vector<std::string> paths{
      "End time", "Parallel", "Output", "Observables", "Checkpoint"};
    return paths;
  }

  template struct RunParameters<2>;
  template struct RunParameters<3>;
} // namespace mpm_granular::Solver
