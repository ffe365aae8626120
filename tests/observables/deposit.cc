// Front, height, area and profile of a staircase of points, along several
// run-out directions and with gravity along several axes.

#include "hand_made_body.h"

#include <mpm_granular/observables/center_of_mass.h>
#include <mpm_granular/observables/deposit_area.h>
#include <mpm_granular/observables/extent.h>
#include <mpm_granular/observables/maximum_speed.h>
#include <mpm_granular/observables/surface.h>

#include <iostream>
#include <string>

using namespace Test;

void
print(Observables::Observable<3> &observable,
      const Body<3>              &body,
      const std::string          &run_out)
{
  const Observables::Frame<3> frame(body.mesh, run_out, body.gravity);
  const auto                  columns = observable.columns();
  const auto values = observable.values(body.snapshot(), frame);
  for (unsigned int c = 0; c < columns.size(); ++c)
    std::cout << "  " << columns[c] << " " << values[c];
  std::cout << std::endl;
}



/// An Extent whose entries are those of @p text.
Observables::Extent<3>
extent(const std::string &text)
{
  Observables::Extent<3> result;
  // Which entries there are depends on values read before.
  for (unsigned int repetition = 0; repetition < 2; ++repetition)
    {
      ParameterHandler prm;
      result.add_parameters(prm);
      prm.parse_input_from_string(text, "", true);
    }
  return result;
}



int
main()
{
  // Cubes of side 0.5, a point in the middle of each: 4 cubes high in the first
  // column along x, then 3, 2, 1; two deep in y, where the second row is one
  // lower. The mesh is [0,4] x [0,1] x [-1,3], gravity along -z, so the lowest
  // cubes lie 1 above the lowest point of the mesh, on a table.
  const auto fill = [](Body<3> &body, const unsigned int up) {
    const unsigned int along = up == 2 ? 0 : 2;
    for (unsigned int column = 0; column < 4; ++column)
      for (unsigned int row = 0; row < 2; ++row)
        for (unsigned int level = 0; level + row < 4 - column; ++level)
          {
            Point<3> x;
            x[along] = 0.25 + 0.5 * column;
            x[1]     = 0.25 + 0.5 * row;
            x[up]    = 0.25 + 0.5 * level;
            body.add(x, 1., 0.125);
          }
  };
  const std::string           column = "set Height of = column\n"
                                       "set Column position = 1.25\n"
                                       "set Column reach = 0.1\n";
  Observables::Extent<3>      whole;
  Observables::Extent<3>      third = extent(column);
  Observables::Extent<3>      half  = extent("set Mass fraction = 0.5");
  Observables::DepositArea<3> area;

  std::cout << "Up is z" << std::endl;
  Body<3> body({0., 0., -1.},
               {4., 1., 3.},
               {8, 2, 8},
               Tensor<1, 3>({0., 0., -2.}));
  fill(body, 2);
  print(whole, body, "x");
  print(third, body, "x");
  print(half, body, "x");
  print(whole, body, "-x");

  // Bins of 0.5, each with two columns over the depth, from the mesh's bottom:
  // 0.5 ((3 + 2.5)/2 + (2.5 + 2)/2 + (2 + 1.5)/2 + (1.5 + 0)/2) = 3.75.
  ParameterHandler prm;
  area.add_parameters(prm);
  prm.parse_input_from_string("set Area bin width = 0.5");
  print(area, body, "x");

  const Observables::Frame<3> frame(body.mesh, "x", body.gravity);
  const auto                  surface =
    Observables::find_surface(body.points, MPI_COMM_SELF, frame, 0.5);
  for (unsigned int bin = 0; bin < surface.height.size(); ++bin)
    std::cout << "  surface " << surface.position(bin) << " "
              << surface.height[bin] << std::endl;

  // Columns, and levels, of 7, 5, 3 and 1 cubes; rows of 10 and 6.
  Observables::CenterOfMass<3> center;
  print(center, body, "x");
  Observables::MaximumSpeed<3> speed;
  body.points.velocity[0][3] = 2.;
  body.points.velocity[1][3] = -3.;
  body.points.velocity[2][3] = 6.;
  body.points.velocity[0][5] = 6.5;
  print(speed, body, "x");

  std::cout << "Up is -x" << std::endl;
  Body<3> turned({-3., 0., 0.},
                 {1., 1., 4.},
                 {8, 2, 8},
                 Tensor<1, 3>({2., 0., 0.}));
  fill(turned, 0);
  for (double &x : turned.points.position[0])
    x = -x;
  print(whole, turned, "z");
  print(third, turned, "z");
  print(area, turned, "z");
}
