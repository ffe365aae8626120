// Which name is meant.

#include <mpm_granular/parameters/name_distance.h>

#include <iostream>

int
main()
{
  const std::vector<std::string> names = {"Young modulus",
                                          "Poisson ratio",
                                          "Density",
                                          "Friction angle",
                                          "CFL",
                                          "x_min"};
  for (const std::string typed : {"Youngs modulus",
                                  "young modulus",
                                  "Poison ration",
                                  "Dnesity",
                                  "Friction",
                                  "frction angel",
                                  "CLF",
                                  "xmin",
                                  "x",
                                  "Viscosity",
                                  ""})
    std::cout << "'" << typed
              << "':" << mpm_granular::Parameters::did_you_mean(typed, names)
              << std::endl;
}
