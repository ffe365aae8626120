// --set: stronger than the file, the last one counts, blanks do not matter.

#include "example_group.h"

using namespace Example;

int
main()
{
  const std::string file = write_file("input.prm",
                                      "subsection Body force\n"
                                      "  set Gravity = 0, 0, -9.81\n"
                                      "end\n");
  Everything        group;
  Parameters::read(group,
                   file,
                   {"Body force/Gravity=1, 2, 3",
                    " Body force / Gravity = 4, 5, 6 ",
                    "Output/Directory=a=b",
                    "Materials/sand/Law=plastic",
                    "Materials/sand/Order=3"});
  std::cout << "Gravity: " << group.gravity << std::endl
            << "Directory: " << group.directory << std::endl
            << "Order: "
            << dynamic_cast<Plastic &>(*group.materials["sand"].law).order
            << std::endl;

  // Entries of the file that an override makes void are no mistakes then.
  const std::string other_choice = "subsection Materials\n"
                                   "  subsection sand\n"
                                   "    set Law = plastic\n"
                                   "    set Friction angle = 12.3456789\n"
                                   "  end\n"
                                   "end\n";
  write_file("input.prm", other_choice);
  Parameters::read(group, "input.prm", {"Output/Directory=there"});
  std::cout << "No digit is lost: "
            << (dynamic_cast<Plastic &>(*group.materials["sand"].law)
                  .friction_angle == 12.3456789)
            << std::endl;
  Parameters::read(group, "input.prm", {"Materials/sand/Law=elastic"});
  std::cout << "Law: " << group.materials["sand"].law.chosen_name()
            << std::endl;
  Parameters::read(group, "input.prm", {"Materials/Names=clay"});
  std::cout << "Materials: " << group.materials.all_names().size() << std::endl;
  expect_refusal_of("subsection Materials\n"
                    "  subsection sand\n"
                    "    set Frction angle = 12\n"
                    "  end\n"
                    "end\n",
                    {"Materials/sand/Law=elastic"});
  expect_refusal_of(other_choice + "subsection Otput\nend\n",
                    {"Materials/sand/Law=elastic"});

  expect_refusal_of("", {"Output/Directory"});
  expect_refusal_of("", {"=3"});
  expect_refusal_of("", {"Output/Directory=run#3"});
  expect_refusal_of("", {"Output/Directry=run"});
}
