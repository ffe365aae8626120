// The energies of a few points, computed by hand, with gravity in a direction
// of its own.

#include "hand_made_body.h"

#include <mpm_granular/observables/energies.h>

#include <iostream>
#include <string>

using namespace Test;

void
print(const std::string        &name,
      Observables::Energies<2> &energies,
      const Body<2>            &body)
{
  const Observables::Frame<2> frame(body.mesh, "x", body.gravity);
  const auto                  columns = energies.columns();
  const auto                  values  = energies.values(body.snapshot(), frame);
  std::cout << name << std::endl;
  for (unsigned int c = 0; c < columns.size(); ++c)
    std::cout << "  " << columns[c] << " " << values[c] << std::endl;
}



int
main()
{
  const SimpleLaw<2> soft(2.), stiff(4.);

  // The mesh is [1,3] x [-2,2]. Gravity points along (3,-4)/5: the lowest point
  // is the corner (3,-2), the height of x is (-3 (x-3) + 4 (y+2))/5.
  Body<2> body({1., -2.}, {3., 2.}, {2, 2}, Tensor<1, 2>({6., -8.}));
  body.laws = {&soft, &stiff};

  // Kinetic 1/2 2 (9 + 16) = 25; elastic 0.5 (1 + 2 + 3 + 4)/2 = 2.5; height
  // (3 + 8)/5 = 2.2, potential 2 10 2.2 = 44.
  std::size_t i              = body.add({2., 0.}, 2., 0.5);
  body.points.velocity[0][i] = 3.;
  body.points.velocity[1][i] = -4.;
  for (unsigned int c = 0; c < 4; ++c)
    body.points.stress[c][i] = c + 1.;

  // At rest; elastic 2 (8)/4 = 4; at the lowest point, so no potential.
  i                        = body.add({3., -2.}, 7., 2.);
  body.points.material[i]  = 1;
  body.points.stress[3][i] = 8.;

  Observables::Energies<2> energies;
  print("Initial state", energies, body);

  // Kinetic falls by 25, the ledger accounts for 20 + 2 + 1 - (-1) = 24 of it:
  // one joule of 44 is missing.
  body.points.velocity[0][0] = 0.;
  body.points.velocity[1][0] = 0.;
  body.ledger                = {20., -1., 2., 1.};
  print("Later", energies, body);

  // Damping took the missing joule.
  body.ledger.damping = 1.;
  print("With damping", energies, body);

  // Without gravity no potential energy, and the closure is relative to the
  // initial total of 25 + 6.5.
  body.points.velocity[0][0] = 3.;
  body.points.velocity[1][0] = -4.;
  body.gravity               = 0.;
  body.ledger                = {};
  Observables::Energies<2> weightless;
  print("Without gravity", weightless, body);
  body.ledger.dissipated = 3.15;
  print("Without gravity, later", weightless, body);
}
