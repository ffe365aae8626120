// Entries and subsections that do not exist are refused with the nearest name,
// or with what makes them exist.

#include "example_group.h"

using namespace Example;

int
main()
{
  std::cout << "Misspelt entry: ";
  expect_refusal_of("subsection Materials\n"
                    "  subsection sand\n"
                    "    set Youngs modulus = 1e7\n"
                    "  end\n"
                    "end\n");
  std::cout << "Misspelt subsection: ";
  expect_refusal_of("subsection Boddy force\n"
                    "  set Gravity = 1, 2, 3\n"
                    "end\n");
  std::cout << "Misspelt empty subsection: ";
  expect_refusal_of("\nsubsection Ouput\nend\n");
  std::cout << "Misspelt name: ";
  expect_refusal_of("", {"Materials/snad/Law=elastic"});
  std::cout << "Name that is not listed: ";
  expect_refusal_of("", {"Materials/gravel/Law=elastic"});
  std::cout << "Entry of another choice: ";
  expect_refusal_of("", {"Materials/sand/Friction angle=20"});
  std::cout << "Entry for another value: ";
  expect_refusal_of("", {"Output/Share=1"});
  std::cout << "Subsection of another choice: ";
  expect_refusal_of("", {"Materials/sand/Inner law/Law=elastic"});
  std::cout << "Entry of another subsection: ";
  expect_refusal_of("set Gravity = 1, 2, 3\n");
  std::cout << "Entry unlike all others: ";
  expect_refusal_of("subsection Output\n  set Compression = 9\nend\n");
  std::cout << "Subsection unlike all others: ";
  expect_refusal_of("subsection Thermodynamics\n  set Heat = 9\nend\n");
}
