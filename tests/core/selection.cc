// Selection: whichever entries follow each other, repeated any number of times,
// the copies are those of a plain loop.

#include <mpm_granular/core/selection.h>

#include <array>
#include <iostream>

using namespace mpm_granular;

int
main()
{
  constexpr unsigned int n = Selection::n, n_before = 5;

  std::array<double, n_before + n> from;
  for (unsigned int i = 0; i < from.size(); ++i)
    from[i] = 1.5 * i - 4.;

  // A bit for each but the first: whether it is the entry after the one before.
  unsigned int n_right = 0;
  for (unsigned int steps = 0; steps < (1u << (n - 1)); ++steps)
    for (const std::uint32_t first : {0u, n_before})
      {
        std::array<std::uint32_t, n> entries{{first}};
        for (unsigned int i = 1; i < n; ++i)
          entries[i] = entries[i - 1] + (steps >> (i - 1) & 1);

        std::array<double, n + 2> to;
        to.fill(-1.);
        Selection(entries.data()).copy(from.data(), to.data() + 1);

        bool is_right = to[0] == -1. && to[n + 1] == -1.;
        for (unsigned int i = 0; i < n; ++i)
          is_right = is_right && to[i + 1] == from[entries[i]];
        n_right += is_right;
      }
  std::cout << n_right << " of " << 2 * (1u << (n - 1)) << " selections right"
            << std::endl;
}
