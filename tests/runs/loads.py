"""Tractions and prescribed motion against closed forms: a confined elastic column
under a slowly rising pressure, and under a slowly moving piston, is in a state of
uniaxial strain with the modulus K + 4G/3."""

import itertools

from _case import ELASTIC, KINDS, Checks, body, box, points_per_cell, run

checks = Checks()
YOUNG, POISSON = 1e6, 0.25
MODULUS = YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))


def column(dim, kind, top):
    sides = ["x_min", "x_max", "y_min", "y_max", "z_min", "z_max"][:2 * dim]
    axis = "xyz"[dim - 1]
    return f"""
set Dimension = {dim}
set End time  = 1
{box(dim, [0., 0., 0.], [.5, .5 if dim == 3 else 1., 1.],
     [2, 2 if dim == 3 else 8, 8], kind)}
{body(dim, [0., 0., 0.], [.5, .5 if dim == 3 else 1., 1.],
      points_per_cell(dim, kind),
      material=ELASTIC.format(density=1000, young=YOUNG, poisson=POISSON))}
subsection Boundary conditions
  set Names = walls, top
  subsection walls
    set Boundaries = {', '.join(sides[:-1])}
    set Type       = roller
  end
  subsection top
    set Boundaries = {axis}_max
    {top}
  end
end
subsection Body force
  set Gravity = {'0, 0' if dim == 2 else '0, 0, 0'}
end
"""


for dim, kind in itertools.product((2, 3), KINDS):
    name = f"{dim}D, {kind}"
    zeros = "0; " * (dim - 1)
    # Pressure p = 1 kPa t: strain p/M, energy p^2/(2M) per volume.
    volume = .5 if dim == 2 else .25
    result = run(column(dim, kind, f"""set Type = traction
    set Traction = {zeros}-1000*t"""))
    if result.exit_code != 0:
        checks.that(False, f"{name}: traction", result.text)
        continue
    expected = volume * 1000.**2 / (2 * MODULUS)
    # Inertia: the load rises in 1 s, waves need 0.03 s.
    checks.that(abs(result.last("elastic_energy") - expected) < .1 * expected,
                f"{name}: energy under pressure",
                f"{result.last('elastic_energy')} instead of {expected}")
    checks.that(abs(result.last("boundary_work") - expected) < .1 * expected,
                f"{name}: work of pressure",
                f"{result.last('boundary_work')} instead of {expected}")

    # A piston that moves by 1 mm.
    result = run(column(dim, kind, f"""set Type = prescribed displacement
    set Displacement = {zeros}-1e-3*t
    set Components = {'xyz'[dim - 1]}"""))
    expected = volume * MODULUS * 1e-3**2 / 2
    checks.that(abs(result.last("elastic_energy") - expected) < .1 * expected,
                f"{name}: energy under a piston",
                f"{result.last('elastic_energy')} instead of {expected}")
    checks.that(abs(result.last("boundary_work") - expected) < .1 * expected,
                f"{name}: work of a piston",
                f"{result.last('boundary_work')} instead of {expected}")
checks.exit()
