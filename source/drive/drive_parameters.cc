#include <deal.II/base/patterns.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/drive/drive_parameters.h>
#include <mpm_granular/drive/loading.h>
#include <mpm_granular/parameters/name_distance.h>
#include <mpm_granular/parameters/pattern_text.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace mpm_granular::Drive
{
  using namespace dealii;

  DriveParameters::DriveParameters()
    : materials({"sand"})
  {}



  void
  DriveParameters::add_parameters(ParameterHandler &prm)
  {
    prm.enter_subsection("Materials");
    materials.add_parameters(prm,
                             "Materials, each with a subsection of its name.");
    prm.leave_subsection();

    prm.enter_subsection("Drive");
    prm.add_parameter("Material",
                      material,
                      "Name of the material to test; nothing: the first one.");
    prm.add_parameter("Test",
                      test,
                      test_documentation(),
                      Patterns::Selection(test_names()));
    prm.add_parameter("Initial stress",
                      initial_stress,
                      "Normal stresses xx, yy, zz at the start, negative in "
                      "compression. Units: Pa.",
                      Patterns::List(Patterns::Double(), 3, 3));
    prm.add_parameter("Strain rate",
                      strain_rate,
                      "Rate of the strain that is driven. Units: 1/s.",
                      Parameters::positive_number());
    prm.add_parameter("Strain",
                      strains,
                      "The strain at the end, positive in the direction of the "
                      "test; or several, up to each of which the test goes in "
                      "turn: 0.05, 0.04, 0.1 unloads and loads again. It is "
                      "the integral of the rate, a logarithmic strain, in "
                      "shear the shear angle.",
                      Patterns::List(Patterns::Double(), 1));
    prm.add_parameter("Steps",
                      n_steps,
                      "How many steps all of it takes.",
                      Patterns::Integer(1));
    prm.leave_subsection();

    prm.enter_subsection("Output");
    prm.add_parameter("Directory",
                      directory,
                      "Folder for all files of the test, made if it is not "
                      "there. One that is not empty is refused unless "
                      "--overwrite is given.");
    prm.leave_subsection();
  }



  void
  DriveParameters::check() const
  {
    for (const auto &name : materials.all_names())
      try
        {
          materials[name].check();
        }
      catch (const InputError &error)
        {
          throw InputError("Materials/" + name + ": " + error.what());
        }
    const auto &names = materials.all_names();
    require(!names.empty(),
            "Materials/Names is empty: a test needs a material.");
    require(material.empty() ||
              std::find(names.begin(), names.end(), material) != names.end(),
            "Drive/Material = " + material +
              " is not a material; Materials/Names has: " +
              Parameters::quoted_list(names) + ".");
    double before = 0.;
    for (const double strain : strains)
      {
        std::ostringstream text;
        text << "Drive/Strain: each strain must differ from the one before it, "
                "the first one from 0; "
             << strain << " does not.";
        require(strain != before, text.str());
        before = strain;
      }
    require(n_steps >= strains.size(),
            "Drive/Steps must be at least the number of values in "
            "Drive/Strain.");
    require(!directory.empty(), "Output/Directory is empty.");
  }



  const Materials::Material<3> &
  DriveParameters::tested_material() const
  {
    return materials[material.empty() ? materials.all_names().front() :
                                        material];
  }
} // namespace mpm_granular::Drive
