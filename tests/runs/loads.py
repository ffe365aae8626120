"""Tractions, prescribed motion and forces of place against closed forms: a confined
elastic column under a slowly rising pressure, and under a slowly moving piston, is
in a state of uniaxial strain with the modulus K + 4G/3; a block that a spring pulls
to a place moves as a point mass does, for a force that is linear in place is
interpolated exactly."""

import itertools

from _case import (DIMENSIONS, ELASTIC, KINDS, Checks, body, boundaries, box, levels,
                   points_per_cell, run)

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


for dim, kind in itertools.product(DIMENSIONS, KINDS):
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

    # A piston that moves by 1 mm, also over cells of three sizes.
    expected = volume * MODULUS * 1e-3**2 / 2
    for mesh in ("", levels(f"if(x < 0.3, 2, 0) + if({'xyz'[dim - 1]} < 0.4, 1, 0)",
                            2, 1000)):
        result = run(column(dim, kind, f"""set Type = prescribed displacement
    set Displacement = {zeros}-1e-3*t
    set Components = {'xyz'[dim - 1]}""") + mesh)
        piston = "a piston" + (" over cells of three sizes" if mesh else "")
        checks.that(result.exit_code == 0, f"{name}: {piston}", result.text)
        for quantity in ("elastic_energy", "boundary_work"):
            checks.that(abs(result.last(quantity) - expected) < .1 * expected,
                        f"{name}: {quantity} under {piston}",
                        f"{result.last(quantity)} instead of {expected}")

# A spring pulls all of a block to a place: the centre of mass follows symplectic
# Euler's oscillator to round-off.
STIFFNESS, SPEED, STEP = 10., .5, 1e-3
for dim in (2, 3):
    sides = ["x_min", "x_max", "y_min", "y_max", "z_min", "z_max"][:2 * dim]
    result = run(f"""
set Dimension = {dim}
set End time  = 0.4
{box(dim, [0., 0., 0.], [1., 1., 1.], [10, 10, 10])}
{body(dim, [.3, .3, .3], [.7, .7, .7],
      material=ELASTIC.format(density=1000, young=1e6, poisson=.3))}
{boundaries(all=("free", sides))}
subsection Initial state
  set Velocity = {SPEED}; 0{'; 0' * (dim - 2)}
end
subsection Body force
  set Gravity = {'0, 0' if dim == 2 else '0, 0, 0'}
  set Force   = {STIFFNESS}*(0.5 - x); 0{'; 0' * (dim - 2)}
end
subsection Time step
  set Type       = fixed
  set Fixed step = {STEP}
end
""", "Output/Observables interval=0")
    if result.exit_code != 0:
        checks.that(False, f"{dim}D spring", result.text)
        continue
    # With the interval 0 there is a row for the start and one for each step.
    checks.that(result["step"] == list(range(401)), f"{dim}D: rows",
                str(result["step"]))
    place, speed, deviation = .5, SPEED, 0.
    for found in result["center_x"][1:]:
        speed += STEP * STIFFNESS * (.5 - place)
        place += STEP * speed
        deviation = max(deviation, abs(found - place))
    checks.that(deviation < 1e-10, f"{dim}D: place under a spring",
                str(deviation))
    # What the spring takes from the motion of the whole; strain, some 2e-4, has
    # next to nothing of it.
    mass = result["mass"][0]
    expected = mass * (speed**2 - SPEED**2) / 2
    work = result.last("boundary_work")
    checks.that(abs(result.last("closure")) < 2e-3, f"{dim}D: energy balance",
                str(result.last("closure")))
    checks.that(abs(work - expected) < .005 * abs(expected),
                f"{dim}D: work of a spring", f"{work} instead of {expected}")
checks.exit()
