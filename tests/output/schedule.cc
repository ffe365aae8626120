// Instants of output: none is missed or doubled by round-off of the time.

#include <mpm_granular/output/schedule.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace mpm_granular;

int
main()
{
  // Ten steps of 0.01 sum up to a little less than 0.1, and so on.
  Output::Schedule tenths(0.1);
  unsigned int     n_passed = 0;
  double           time     = 0.;
  for (unsigned int step = 0; step < 1000; ++step)
    {
      time += 0.01;
      n_passed += tenths.passes(time);
    }
  std::cout << "Passed up to 10 s: " << n_passed << std::endl
            << "Next: " << tenths.next() << std::endl;

  // Steps that are cut to end on the next instant.
  Output::Schedule thirds(1. / 3., 2.);
  time     = 2.;
  n_passed = 0;
  for (unsigned int step = 0; step < 300000 && time < 102.; ++step)
    {
      const double dt = std::min(0.07, thirds.next() - time);
      time += dt;
      n_passed += thirds.passes(time);
    }
  std::cout << "Passed from 2 s to 102 s: " << n_passed << std::endl;

  // A long step passes several instants, which count as one.
  Output::Schedule seconds(1.);
  std::cout << seconds.passes(0.5) << seconds.passes(3.5) << seconds.passes(3.9)
            << seconds.passes(4.) << std::endl
            << "Next: " << seconds.next() << std::endl;

  Output::Schedule never(0.);
  std::cout << "Without interval: " << never.passes(1e9)
            << ", next is infinite " << std::isinf(never.next()) << std::endl;
}
