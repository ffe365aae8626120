// Values that decide which entries there are: names, choices, and choices
// within choices, in any order.

#include "example_group.h"

using namespace Example;

int
main()
{
  const std::string file = write_file("input.prm",
                                      "subsection Output\n"
                                      "  set Counts = 7, 8\n"
                                      "  set Fields = speed, stress\n"
                                      "end\n"
                                      "subsection Materials\n"
                                      "  subsection clay\n"
                                      "    subsection Inner law\n"
                                      "      set Friction angle = 12.5\n"
                                      "      set Law = plastic\n"
                                      "    end\n"
                                      "    set Law = viscous\n"
                                      "  end\n"
                                      "  subsection silt\n"
                                      "    set Young modulus = 1234567.5\n"
                                      "  end\n"
                                      "  set Names = clay, silt\n"
                                      "end\n");
  Everything        group;
  for (const auto &entry : Parameters::read(group, file))
    std::cout << entry.path() << " = " << entry.value << " (default "
              << entry.default_value << ")" << std::endl;

  const auto &outer = dynamic_cast<Viscous &>(*group.materials["clay"].law);
  const auto &inner = dynamic_cast<Plastic &>(*outer.inner);
  const auto &other = dynamic_cast<Elastic &>(*group.materials["silt"].law);
  std::cout << std::endl << "Names:";
  for (const auto &name : group.materials.all_names())
    std::cout << ' ' << name;
  std::cout << std::endl
            << "Friction angle of the inner law: " << inner.friction_angle
            << std::endl
            << "Young's modulus, of which no digit is lost: "
            << (other.young_modulus == 1234567.5) << std::endl
            << "Counts: " << group.counts[0] << ' ' << group.counts[1]
            << std::endl
            << "Fields: " << group.fields.size() << std::endl;
}
