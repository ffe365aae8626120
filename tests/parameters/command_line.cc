// What is understood on the command line.

#include "example_group.h"

#include <mpm_granular/parameters/command_line.h>

using namespace Example;

void
show(const std::vector<const char *> &arguments)
{
  std::vector<const char *> all = {"./mpm_granular"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  expect_refusal([&] {
    const auto line = Parameters::parse_command_line(all.size(), all.data());
    std::cout << line.text << std::endl
              << "  task " << static_cast<int>(line.task) << ", file '"
              << line.file << "', overwrite " << line.overwrite << ", style "
              << static_cast<int>(line.print_style);
    if (!line.resume.empty())
      std::cout << ", resume '" << line.resume << "'";
    std::cout << std::endl;
    for (const auto &override : line.overrides)
      std::cout << "  " << override << std::endl;
    throw InputError("");
  });
}

int
main()
{
  show({"wall.prm"});
  show({"--check", "wall.prm", "--overwrite"});
  show({"wall.prm",
        "--set",
        "Body force/Gravity=0, 0, -1",
        "--set=Output/Directory=it's",
        "--output",
        "there"});
  show({"--print-parameters"});
  show({"--print-parameters", "wall.prm"});
  show({"wall.prm", "--print-parameters=markdown"});
  show({"--help"});
  show({"--version", "--check"});
  show({"--resume", "there", "--set", "End time=3"});
  show({"--check", "--resume=there"});

  show({});
  show({"--check"});
  show({"one.prm", "two.prm"});
  show({"--chek", "wall.prm"});
  show({"wall.prm", "--resume", "there"});
  show({"--resume", "there", "--overwrite"});
  show({"--resume", "there", "--output", "elsewhere"});
  show({"--resume", "there", "--print-parameters"});
  show({"--resume"});
  show({"wall.prm", "-c"});
  show({"wall.prm", "--set"});
  show({"wall.prm", "--output=a", "--output=b"});
  show({"wall.prm", "--print-parameters=json"});
}
