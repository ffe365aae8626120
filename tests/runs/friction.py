"""A stiff block on a rough incline: it slides with g (sin a - mu cos a), or stays if
mu > tan a. The incline is the floor of the mesh, and gravity is inclined. Poisson's
ratio is 0: a block that bulges is lifted a little by errors of points that cross
cells, by some mm/s, and the wall has to stop its lower side again."""

import itertools
import math
import os

from _case import (DIMENSIONS, ELASTIC, KINDS, Checks, body, boundaries, box, levels,
                   points_per_cell, run)

checks = Checks()
GRAVITY, END = 9.81, 0.5
# Gravity grows slowly: put on at once it would make the block jump.
RAMP = 0.1


def block(dim, kind, angle, friction):
    thick = [.2] if dim == 3 else []
    names = ["x_min", "x_max", "y_min", "y_max", "z_min", "z_max"][:2 * dim]
    floor = names[-2]
    sides = ["y_min", "y_max"] if dim == 3 else []
    others = [name for name in names if name not in (floor, *sides)]
    down = [GRAVITY * math.sin(angle), -GRAVITY * math.cos(angle)]
    conditions = {"floor": ("Coulomb friction", [floor]),
                  "rest": ("free", others)}
    if sides:
        conditions["sides"] = ("roller", sides)
    return f"""
set Dimension = {dim}
set End time  = {END}
{box(dim, [0.] * dim, [2., *thick, .6], [20, *([2] * len(thick)), 6], kind)}
{body(dim, [.2, *([0.] * len(thick)), 0.], [.6, *thick, .2],
      points_per_cell(dim, kind),
      material=ELASTIC.format(density=1500, young=1e7, poisson=0))}
{boundaries(**conditions)}
subsection Boundary conditions
  subsection floor
    set Friction coefficient = {friction}
  end
end
subsection Body force
  set Gravity     = {', '.join(map(str, [down[0], *([0.] * len(thick)),
                                         down[1]]))}
  set Time factor = min(1, t/{RAMP})
end
"""


# Small cells that stay behind: the block slides out of them.
JUMPS = levels("1.5 - 4*abs(x - 0.5)", 1)

for dim, kind in itertools.product(DIMENSIONS, KINDS):
    for degrees, friction, mesh in ((30, .3, ""), (45, .5, ""), (30, .3, JUMPS)):
        angle = math.radians(degrees)
        result = run(block(dim, kind, angle, friction) + mesh)
        name = (f"{dim}D, {kind}, {degrees} degrees" +
                (", cells of two sizes" if mesh else ""))
        if result.exit_code != 0:
            checks.that(False, name, result.text[-2000:])
            continue
        path = result.last("center_x") - result["center_x"][0]
        slid = END - RAMP
        expected = GRAVITY * (math.sin(angle) - friction * math.cos(angle)) * (
            slid**2 / 2 + RAMP * slid / 2 + RAMP**2 / 6)
        print(f"{name}: {path:.5f} m, {path / expected - 1:+.4%}")
        checks.that(abs(path - expected) < .005 * expected, f"{name}: slides",
                    f"{path} instead of {expected}")
    # With a coefficient close to tan(15 degrees) = 0.27 the uphill edge, where the
    # pressure is least, would slip a little.
    result = run(block(dim, kind, math.radians(15), .6))
    path = result.last("center_x") - result["center_x"][0]
    print(f"{dim}D, {kind}, 15 degrees: {path:.2e} m")
    # Its elastic shear under its weight: some rho g sin(a) h^2 / (2 G).
    checks.that(result.exit_code == 0 and abs(path) < 1e-4,
                f"{dim}D, {kind}: stays", str(path))

# Shared nodes have complete forces when the walls act: any number of ranks.
if os.environ.get("MPM_MPIEXEC"):
    for dim, kind in ((2, "simplices"), (3, "hypercubes")):
        text = block(dim, kind, math.radians(30), .3)
        one = run(text, "End time=0.2")
        three = run(text, "End time=0.2", ranks=3)
        difference = abs(three.last("center_x") - one.last("center_x"))
        print(f"{dim}D, {kind}: three ranks differ by {difference:.1e} m")
        checks.that(three.exit_code == 0 and difference < 1e-9,
                    f"{dim}D, {kind}: three ranks", three.text[-2000:])

# The ledger: friction takes what weight gives and motion does not have.
result = run(block(2, "simplices", math.radians(30), .3), "Body force/Time factor=1",
             "End time=0.3")
given = result["potential_energy"][0] - result.last("potential_energy")
taken = given - result.last("kinetic_energy")
print(f"friction takes {-result.last('boundary_work') / given:.4f} of the weight's "
      f"work, rigid {.3 / math.tan(math.radians(30)):.4f}; closure "
      f"{result.last('closure'):.1e}")
checks.that(abs(result.last("boundary_work") + taken) < .02 * taken and
            abs(result.last("closure")) < 1e-3, "ledger",
            f"{result.last('boundary_work')} and {-taken}")

for setting in ("Scheme/Mass matrix=near-consistent", "Scheme/Stress order=USF"):
    refused = run(block(2, "simplices", .5, .3), setting)
    checks.that(refused.exit_code == 1 and "Coulomb friction" in refused.text,
                setting, refused.text)
checks.exit()
