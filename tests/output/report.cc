// What the program says: the two lines that other programs read, the pre-flight
// report and its warnings, numbers for people, and the log, which also gets
// what was said before it was opened and what a terminal only shows in passing.

#include <mpm_granular/output/number_text.h>
#include <mpm_granular/output/preflight.h>
#include <mpm_granular/output/progress.h>

#include <fstream>
#include <iostream>
#include <sstream>

using namespace mpm_granular::Output;

void
numbers()
{
  for (const double count : {0., 999., 1000., 1234567., -20000.})
    std::cout << count_text(count) << " | ";
  std::cout << std::endl;
  for (const double seconds :
       {0.5234, 59.94, 59.96, 245., 3599.7, 12000., 200000., -1.})
    std::cout << duration_text(seconds) << " | ";
  std::cout << std::endl;
  for (const double bytes : {0., 999., 1000., 12.34e6, 1.5e15})
    std::cout << bytes_text(bytes) << " | ";
  std::cout << std::endl;
}



void
preflight()
{
  Preflight report;
  report.dimension           = 2;
  report.n_cells             = 16000;
  report.n_nodes             = 8241;
  report.mean_cell_size      = 0.05;
  report.n_points            = 6400;
  report.n_filled_cells      = 3200;
  report.min_points_per_cell = 1;
  report.max_points_per_cell = 4;
  report.mass                = 3000.;
  report.materials = {{"sand", "drucker prager", 1500., 29.957, 6400}};
  report.averaging = "cells";
  report.pressure_filter_rate = 120.;
  report.end_time             = 2.;
  report.stable_dt            = 4e-4;
  report.chosen_dt            = 5e-4;
  report.throughput           = 12.8;
  report.n_files              = 21;
  report.bytes_per_file       = 0.5e6;
  report.add_warnings();
  std::cout << report.text();
}



void
console()
{
  std::ostringstream screen;
  {
    Console console(screen, false, true);
    console.say("early");
    console.open_log("log.txt");
    console.say("late\nand later\n");
    console.renew("in passing");
    console.log("for the log");

    Console silent(screen, true, false);
    silent.say("from another process");
    silent.renew("from another process");
  }
  std::cout << "Screen:" << std::endl << screen.str();
  std::ifstream file("log.txt");
  std::cout << "Log:" << std::endl << file.rdbuf();

  std::ostringstream terminal;
  {
    Console console(terminal, true, true);
    console.renew("10 %");
    console.renew("20 %");
    console.say("message");
  }
  for (const char character : terminal.str())
    if (character == '\r')
      std::cout << "<return>";
    else if (character == '\033')
      std::cout << "<escape>";
    else
      std::cout << character;
}



int
main()
{
  numbers();
  preflight();
  console();
  std::cout << summary_text({2., 10000, 64000000, 5., 320.2});
}
