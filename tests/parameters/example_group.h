#ifndef tests_parameters_example_group_h
#define tests_parameters_example_group_h

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/tensor.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/core/registry.h>
#include <mpm_granular/parameters/choice.h>
#include <mpm_granular/parameters/dimension.h>
#include <mpm_granular/parameters/named_groups.h>
#include <mpm_granular/parameters/parameter_file.h>
#include <mpm_granular/parameters/parameter_group.h>
#include <mpm_granular/parameters/pattern_text.h>

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

/*
 * A small set of parameters with all that the real one has: named groups, a
 * choice in each of them, a choice within a choice, values of all kinds.
 */
namespace Example
{
  using dealii::ParameterHandler;
  using namespace mpm_granular;

  class Law : public Parameters::ParameterGroup
  {};

  using LawRegistry = Core::Registry<Law>;

  class Elastic : public Law
  {
  public:
    double young_modulus = 1e6;

    void
    add_parameters(ParameterHandler &prm) override
    {
      prm.add_parameter("Young modulus",
                        young_modulus,
                        "Stiffness in tension. Units: Pa.",
                        Parameters::positive_number());
    }
  };

  class Plastic : public Law
  {
  public:
    double       friction_angle = 30.;
    unsigned int order          = 1;

    void
    add_parameters(ParameterHandler &prm) override
    {
      prm.add_parameter("Friction angle",
                        friction_angle,
                        "Steepest slope of a <dry> heap | of any size. Units: "
                        "degrees.",
                        dealii::Patterns::Double(0., 90.));
      prm.add_parameter("Order", order, "Order of the return.");
    }
  };

  /// A law that slows down another one.
  class Viscous : public Law
  {
  public:
    double                  viscosity = 0.25;
    Parameters::Choice<Law> inner{"elastic"};

    void
    add_parameters(ParameterHandler &prm) override
    {
      prm.add_parameter("Viscosity",
                        viscosity,
                        "Resistance to shear. Units: Pa s.",
                        dealii::Patterns::Double(0.));
      prm.enter_subsection("Inner law");
      inner.add_parameters(prm, "Law", "The law that is slowed down:");
      prm.leave_subsection();
    }
  };

  inline const LawRegistry::Entry<Elastic> elastic("elastic", "springs.");
  inline const LawRegistry::Entry<Plastic> plastic("plastic", "friction.");
  inline const LawRegistry::Entry<Viscous> viscous("viscous", "honey.");

  struct Material : public Parameters::ParameterGroup
  {
    Parameters::Choice<Law> law{"elastic"};

    void
    add_parameters(ParameterHandler &prm) override
    {
      law.add_parameters(prm, "Law", "Stress from strain:");
    }
  };

  struct Everything : public Parameters::ParameterGroup
  {
    Parameters::NamedGroups<Material> materials{{"sand"}};
    dealii::Tensor<1, 3>              gravity;
    std::vector<unsigned int>         counts = {4, 5};
    std::vector<std::string>          fields;
    std::string                       scheme    = "FLIP";
    std::string                       directory = "output";
    bool                              write     = true;
    int                               shift     = -2;
    double                            share     = 0.5;

    void
    add_parameters(ParameterHandler &prm) override
    {
      using namespace dealii::Patterns;
      Parameters::declare_dimension(prm, 3);
      prm.enter_subsection("Materials");
      materials.add_parameters(prm, "Names of the materials.");
      prm.leave_subsection();
      prm.enter_subsection("Body force");
      prm.add_parameter("Gravity", gravity, "Of the planet. Units: m/s^2.");
      prm.leave_subsection();
      prm.enter_subsection("Output");
      prm.add_parameter("Directory", directory, "Folder of the results.");
      prm.add_parameter("Write", write, "Whether to write at all.");
      prm.add_parameter("Counts",
                        counts,
                        "Two of them.",
                        List(Integer(1), 2, 2));
      prm.add_parameter("Fields", fields, "What to write.");
      prm.add_parameter("Scheme", scheme, "How.", Selection("FLIP|PIC"));
      Parameters::only_with(prm, "Scheme", "PIC", scheme, [&] {
        prm.add_parameter("Share",
                          share,
                          "How much of it. Units: -.",
                          Double(0., 1.));
      });
      prm.add_parameter("Shift", shift, "By how much.", Integer(-5, 5));
      prm.leave_subsection();
    }

    void
    check() const override
    {
      require(directory != "input", "Output/Directory must not be 'input'.");
    }
  };

  /// Writes a file, to be read by a test.
  inline std::string
  write_file(const std::string &name, const std::string &text)
  {
    std::ofstream(name, std::ios::binary) << text;
    return name;
  }

  /// Does something that is to be refused, and prints the message.
  template <class Function>
  void
  expect_refusal(const Function &function)
  {
    try
      {
        function();
        std::cout << "NOT REFUSED" << std::endl;
      }
    catch (const InputError &error)
      {
        std::cout << error.what() << std::endl;
      }
  }

  /// Reads @p text and @p overrides; they are to be refused.
  inline void
  expect_refusal_of(const std::string              &text,
                    const std::vector<std::string> &overrides = {})
  {
    Everything        group;
    const std::string file = write_file("input.prm", text);
    expect_refusal([&] { Parameters::read(group, file, overrides); });
  }
} // namespace Example

#endif
