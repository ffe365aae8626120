"""The first mode of a bar, fixed at one end (verification problem c): nu = 0,
L = 25 m, E = 100 Pa, rho = 1 kg/m^3, V0 = 1e-3 m/s, so that points stay in their
cells. The velocity of the centre of mass is (2 V0/pi) cos(omega t), omega =
pi/(2 L) sqrt(E/rho). The displacement of the centre of mass converges with
second order, velocities live half a step earlier."""

import math

from _case import ELASTIC, Checks, body, boundaries, box, run

checks = Checks()
LENGTH, YOUNG, SPEED, END = 25., 100., 1e-3, 10.


def bar(n_cells):
    return f"""
set Dimension = 2
set End time  = {END}
{box(2, [0., 0.], (30., 25. / n_cells), (int(30 * n_cells / 25 + .5), 1))}
{body(2, [0., 0.], (LENGTH, 25. / n_cells),
      material=ELASTIC.format(density=1, young=YOUNG, poisson=0))}
{boundaries(walls=("roller", ["x_min", "y_min", "y_max"]),
            end=("free", ["x_max"]))}
subsection Initial state
  set Velocity = {SPEED}*sin(pi*x/50); 0
end
subsection Body force
  set Gravity = 0, 0
end
subsection Scheme
  set Velocity update = FLIP
end
subsection Time step
  set CFL = 0.2
end
subsection Output
  set Observables interval = 0.05
end
"""


OMEGA = math.pi / (2 * LENGTH) * math.sqrt(YOUNG)
errors = []
for n_cells in (10, 20, 40):
    result = run(bar(n_cells))
    if result.exit_code != 0:
        checks.that(False, f"bar of {n_cells} cells", result.text)
        continue
    start = result["center_x"][0]
    squares = [
        (x - start - 2 * SPEED / (math.pi * OMEGA) * math.sin(OMEGA * t))**2
        for t, x in zip(result["time"], result["center_x"])]
    amplitude = 2 * SPEED / (math.pi * OMEGA)
    errors.append(math.sqrt(sum(squares) / len(squares)) / amplitude)
    energies = [k + e for k, e in zip(result["kinetic_energy"],
                                      result["elastic_energy"])]
    print(f"{n_cells} cells: error of displacement {errors[-1]:.2e}, "
          f"energy kept {energies[-1] / energies[0]:.5f}")
    # The reference, a 1D code with lumped FLIP, loses up to 6e-4 here.
    checks.that(.99 < energies[-1] / energies[0] < 1.0001,
                f"{n_cells} cells: energy")

orders = [math.log2(a / b) for a, b in zip(errors, errors[1:])]
print("observed orders", orders)
checks.that(all(1.7 < order < 2.5 for order in orders) and errors[-1] < 5e-3,
            "second order", str(errors))
checks.exit()
