// The documentation shows the entries of everything that can be chosen.

#include "example_group.h"

#include <mpm_granular/parameters/listing.h>

using namespace Example;

int
main()
{
  Everything group;
  Parameters::write(Parameters::documented_entries(group),
                    std::cout,
                    Parameters::Style::markdown);
}
