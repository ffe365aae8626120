// Files named in a parameter file are looked for beside it, and beside the file
// that a link points to.

#include "example_group.h"

#include <mpm_granular/parameters/file_name.h>

#include <filesystem>

using namespace Example;
using Parameters::resolve_input_file;

int
main()
{
  namespace fs = std::filesystem;
  fs::remove_all("case");
  fs::remove_all("links");
  fs::create_directories("case/meshes");
  fs::create_directories("links");
  write_file("case/wall.prm", "");
  write_file("case/meshes/wall.msh", "");
  write_file("case/both.msh", "");
  write_file("links/both.msh", "");
  fs::create_symlink("../case/wall.prm", "links/link.prm");

  const std::string mesh = "meshes/wall.msh", entry = "Mesh/File";
  std::cout << resolve_input_file(mesh, "case/wall.prm", entry) << std::endl
            << resolve_input_file("both.msh", "links/link.prm", entry)
            << std::endl;
  const std::string through_link =
    resolve_input_file(mesh, "links/link.prm", entry);
  std::cout << fs::equivalent(through_link, "case/meshes/wall.msh")
            << std::endl;
  const std::string absolute = fs::absolute("case/both.msh").string();
  std::cout << (resolve_input_file(absolute, "case/wall.prm", entry) ==
                absolute)
            << std::endl
            << resolve_input_file("case/both.msh", "", entry) << std::endl;

  expect_refusal([&] { resolve_input_file("no.msh", "case/wall.prm", entry); });
  expect_refusal([&] { resolve_input_file("meshes", "case/wall.prm", entry); });
  expect_refusal([&] { resolve_input_file("", "case/wall.prm", entry); });
}
