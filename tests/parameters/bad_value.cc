// Values that are not allowed are refused in words, with the unit and with a
// hint where the mistake is a usual one.

#include "example_group.h"

using namespace Example;

int
main()
{
  expect_refusal_of("# A comment\n"
                    "subsection Materials\n"
                    "  subsection sand\n"
                    "    set Young modulus = 1 MPa # with its unit\n"
                    "  end\n"
                    "end\n");
  const std::string sand = "Materials/sand/";
  for (const std::string &assignment :
       {sand + "Young modulus=0",
        sand + "Young modulus=-1e-3",
        sand + "Young modulus=1,5",
        sand + "Young modulus=1e400",
        sand + "Young modulus=nan",
        sand + "Young modulus=",
        sand + "Law=plastics",
        std::string("Output/Write=yes"),
        std::string("Output/Counts=1, 2, 3"),
        std::string("Output/Counts=0, 2"),
        std::string("Output/Scheme=flip"),
        std::string("Output/Shift=9"),
        std::string("Output/Shift=1.5"),
        std::string("Body force/Gravity=0, -9.81"),
        std::string("Body force/Gravity=0, 0, -9.81 m/s^2"),
        std::string("Materials/Names=sand, sand"),
        std::string("Materials/Names=sand/clay")})
    expect_refusal_of("", {assignment});

  // Unsigned numbers must not wrap around.
  expect_refusal_of("", {sand + "Law=plastic", sand + "Order=-1"});
  expect_refusal_of("", {sand + "Law=plastic", sand + "Friction angle=91"});

  // A wrong value is more telling than the unknown entries it brings about.
  expect_refusal_of("subsection Materials\n"
                    "  subsection sand\n"
                    "    set Friction angle = 30\n"
                    "    set Law = plastik\n"
                    "  end\n"
                    "end\n");

  // What only check() can find.
  Everything group;
  Parameters::read(group, "", {"Output/Directory=input"});
  expect_refusal([&] { Parameters::check(group, "input.prm"); });
}
