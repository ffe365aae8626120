// The format of parameter files, and what is refused with file and line.

#include "example_group.h"

#include <filesystem>

using namespace Example;

void
show(const std::string &title, const std::string &text)
{
  Everything group;
  Parameters::read(group, write_file("input.prm", text));
  std::cout << title << ": " << group.gravity << ", " << group.directory
            << std::endl;
}

int
main()
{
  const std::string gravity = "subsection Body force\n"
                              "  set Gravity = 1, 2, 3\n"
                              "end\n";
  show("Nothing", "");
  show("Simple", gravity);
  show(
    "Windows, byte order mark",
    "\xEF\xBB\xBFsubsection Body force\r\n  set Gravity = 1, 2, 3\r\nend\r\n");
  show("Long line, comment in it, no last line end",
       "subsection Body force\n  set Gravity = 1, \\\n # of the moon\n"
       " 2, \\  \n 3 # end\nend");
  show("Twice the same subsection",
       gravity +
         "subsection Output\nend\nsubsection Output\n\tSET  Directory= a "
         "b\nEND\n");
  write_file("included.prm",
             gravity + "subsection Output\nset Directory = a\nend");
  show("Included, then changed",
       "include included.prm\nsubsection Output\nset Directory = b\nend");

  std::cout << "No end: ";
  expect_refusal_of("subsection Materials\n  set Names = sand\n");
  std::cout << "No end, seen by the indentation: ";
  expect_refusal_of("subsection Materials\n"
                    "  subsection sand\n"
                    "    set Law = elastic\n"
                    "end\n"
                    "\n" +
                    gravity);
  std::cout << "One end too many: ";
  expect_refusal_of(gravity + "end\n");
  std::cout << "Twice the same entry: ";
  expect_refusal_of("set Dimension = 2\n" + gravity + "set Dimension = 3\n");
  std::cout << "No set: ";
  expect_refusal_of("Dimension = 2\n");
  std::cout << "No value: ";
  expect_refusal_of("set Dimension\n");
  std::cout << "Not such a file: ";
  expect_refusal_of(std::string(1000, '<'));
  std::cout << "Nothing to include: ";
  expect_refusal_of("include nothing.prm\n");
  std::cout << "Includes itself: ";
  expect_refusal_of("include input.prm\n");
  std::cout << "Includes in a subsection: ";
  expect_refusal_of("subsection Output\ninclude included.prm\nend\n");

  Everything group;
  std::filesystem::create_directory("folder");
  std::cout << "Missing: ";
  expect_refusal([&] { Parameters::read(group, "missing.prm"); });
  std::cout << "Folder: ";
  expect_refusal([&] { Parameters::read(group, "folder"); });
}
