// One message and one exit code for everything that can go wrong.

#include <deal.II/base/exceptions.h>

#include <mpm_granular/core/exceptions.h>
#include <mpm_granular/core/exit_code.h>

#include <iostream>
#include <new>
#include <sstream>

using namespace mpm_granular;
using Core::ExitCode;

template <class Function>
void
show(const Function &function)
{
  std::ostringstream message;
  const auto         original = std::cerr.rdbuf(message.rdbuf());
  const ExitCode     code     = Core::run_and_report([&] {
    function();
    return ExitCode::done;
  });
  std::cerr.rdbuf(original);

  // Function names depend on the compiler.
  std::istringstream lines(message.str());
  std::string        line;
  while (std::getline(lines, line))
    if (line.find("/exit_code.cc") == std::string::npos &&
        line.find("show") == std::string::npos &&
        line.find("main()") == std::string::npos)
      std::cout << line << std::endl;
  std::cout << "  exit code " << static_cast<int>(code) << std::endl;
}

int
main()
{
  dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();

  show([] {});
  show([] { throw InputError("The time step is negative."); });
  show([] { throw ComputationError("Point 3 is lost."); });
  show([] { throw std::bad_alloc(); });
  show([] { throw std::runtime_error("out of range"); });
  show([] { throw 3; });
  // deal.II 9.6 says nothing about a condition that is just "false".
  const int index = 3;
  show([&] { AssertThrow(index < 3, dealii::ExcMessage("a wrong index")); });
}
