// for_each_marked() finds the marked ones and no others, in order, for numbers
// of elements around those of its groups, and marks from none to all.

#include <mpm_granular/core/marks.h>

#include <iostream>
#include <random>
#include <vector>

int
main()
{
  using namespace mpm_granular;
  std::mt19937 random(1);
  for (const double share : {0., .05, .3, 1.})
    {
      bool all_found = true;
      for (unsigned int n = 0; n <= 3 * n_marks + 1; ++n)
        {
          // Behind the first n all are marked; none of these may be found.
          std::vector<unsigned int> is_marked((n / n_marks + 1) * n_marks, 1);
          std::vector<unsigned int> expected, found;
          for (unsigned int i = 0; i < n; ++i)
            {
              is_marked[i] = std::bernoulli_distribution(share)(random);
              if (is_marked[i])
                expected.push_back(i);
            }
          for_each_marked(
            n,
            [&](const std::size_t i) { return is_marked[i] != 0; },
            [&](const unsigned int i) { found.push_back(i); });
          all_found &= found == expected;
        }
      std::cout << "share " << share << ": "
                << (all_found ? "all found" : "NOT all found") << std::endl;
    }
}
