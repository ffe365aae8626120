// The dimension is read before all else, which is passed over.

#include "example_group.h"

using namespace Example;

void
show(const std::string &text, const std::vector<std::string> &overrides = {})
{
  const std::string file = write_file("input.prm", text);
  std::cout << Parameters::read_dimension(file, overrides) << std::endl;
}

int
main()
{
  const std::string other = "subsection A\n  set Dimension = 5\nend\n";
  show("");
  show(other + "set Dimension = 2\n");
  show(other, {"Dimension = 2"});
  show("set Dimension = 2\n", {"Dimension=3"});

  expect_refusal([] { show("set Dimension = 4\n"); });
  expect_refusal([] { show("", {"Dimension=3D"}); });
}
