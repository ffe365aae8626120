// JSON that any reader accepts: strings with all that must be escaped, numbers
// that read back exactly, no infinities. The texts are those of RFC 8259.

#include <mpm_granular/output/json.h>

#include <iostream>
#include <limits>
#include <sstream>
#include <string>

using namespace mpm_granular::Output;

int
main()
{
  std::cout << json_string("plain") << std::endl
            << json_string("a \"quoted\" back\\slash") << std::endl
            << json_string("lines\nand\ttabs\r\x01\x1f") << std::endl
            << json_string("µ-law ü") << std::endl;
  for (const double value : {0., -0., 1., -12345678., 0.1, 1e-300, 1e22})
    std::cout << json_number(value) << std::endl;
  std::cout << json_number(std::numeric_limits<double>::infinity()) << " "
            << json_number(std::numeric_limits<double>::quiet_NaN())
            << std::endl;

  JsonObject inner;
  inner.add("count", 3u)
    .add("yes", true)
    .add("list", std::vector<std::string>{});
  JsonObject outer;
  outer.add("text", "line\nbreak")
    .add("inner", inner)
    .add("list", std::vector<std::string>{"a", "b\"c"})
    .add("empty", JsonObject());

  // Each line after a mark: the suite's tools rewrite lines that look like
  // JSON.
  std::istringstream lines(outer.text());
  for (std::string line; std::getline(lines, line);)
    std::cout << "> " << line << std::endl;
}
