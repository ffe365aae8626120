// Entries are written so that reading the file gives the same again, with the
// defaults and with values from a file.

#include "example_group.h"

#include <mpm_granular/parameters/listing.h>

#include <sstream>

using namespace Example;

std::string
written(const std::vector<Parameters::Entry> &entries)
{
  std::ostringstream text;
  Parameters::write(entries, text, Parameters::Style::parameter_file);
  return text.str();
}

void
show(const std::string &text)
{
  Everything        group;
  const std::string file  = write_file("written.prm", text);
  const std::string again = written(Parameters::read(group, file));
  std::cout << text << "Reading it gives "
            << (again == text ? "the same" : "ANOTHER ONE:\n" + again)
            << std::endl
            << std::endl;
}

int
main()
{
  Everything group;
  show(written(Parameters::read(group, "")));
  show(written(Parameters::read(group,
                                "",
                                {"Materials/Names=silt, clay",
                                 "Materials/silt/Law=viscous",
                                 "Materials/silt/Viscosity=0.123456789",
                                 "Materials/clay/Law=plastic",
                                 "Output/Fields=",
                                 "Output/Write=false"})));
}
