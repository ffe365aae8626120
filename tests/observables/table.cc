// observables.csv: the names and their order are a contract with the programs
// that read it, values read back exactly, rows are there as soon as written.

#include "hand_made_body.h"

#include <mpm_granular/observables/observables_table.h>

#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

using namespace Test;

std::string
contents(const std::string &path)
{
  std::ifstream      file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}



int
main()
{
  const SimpleLaw<2> law(1.);
  Body<2>            body({0., 0.}, {1., 1.}, {2, 2}, Tensor<1, 2>({0., -10.}));
  body.laws   = {&law};
  body.ledger = {1., 2., 3.};
  body.time   = 0.1 + 0.2; // not 0.3
  body.add({0.25, 0.25}, 1., 0.25);
  body.add({0.75, 0.75}, 3., 0.25);

  Observables::ObservablesTable<2> table;
  ParameterHandler                 prm;
  table.add_parameters(prm);
  prm.parse_input_from_string("set Run-out direction = y\n"
                              "set Area bin width = 0.5");
  table.check();

  const std::string path = "observables.csv";
  table.open(path);
  std::cout << "Header as soon as opened:" << std::endl << contents(path);
  table.write(body.snapshot());
  std::istringstream rows(contents(path));
  std::string        row;
  std::getline(rows, row);
  std::getline(rows, row);
  std::cout << "Row:" << std::endl << row << std::endl;
  std::cout << "Time reads back exactly: " << (std::stod(row) == 0.1 + 0.2)
            << std::endl;

  body.time = 1e6;
  table.write(body.snapshot());
  rows.str(contents(path));
  rows.clear();
  unsigned int n_lines = 0;
  for (std::string line; std::getline(rows, line); ++n_lines)
    row = line;
  std::cout << "Lines after a second row: " << n_lines << std::endl
            << "Its time: " << row.substr(0, row.find(',')) << std::endl
            << "Front in memory: " << table.last("front") << std::endl
            << "Unknown column refused: ";
  try
    {
      table.last("no such column");
      std::cout << "no" << std::endl;
    }
  catch (const ExceptionBase &)
    {
      std::cout << "yes" << std::endl;
    }

  Observables::ObservablesTable<2> elsewhere;
  std::cout << "Impossible path refused: ";
  try
    {
      elsewhere.open("no/such/folder/observables.csv");
      std::cout << "no" << std::endl;
    }
  catch (const InputError &)
    {
      std::cout << "yes" << std::endl;
    }
}
