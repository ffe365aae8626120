"""The default scheme runs the wall at 0.8 of the stability limit without a value
that is not a number or a lost point: structured and unstructured meshes, 1 to 16
points per simplex, fluidities from 1 to 1e6, exponents from 0.5 to 10, Young's
moduli from 1e5 to 1e8, and some corners of that box. A collapse ends with less
energy than it began with, and no speed is above that of free fall from the top by
much."""

from _case import INPUTS, IS_DEBUG, SAND, Checks, body, boundaries, box, is_finite, run

checks = Checks()


def wall(dim):
    thick = [.2] if dim == 3 else []
    up = "z" if dim == 3 else "y"
    sides = ["x_min", "x_max"] + (["y_min", "y_max"] if dim == 3 else [])
    return f"""
set Dimension = {dim}
set End time  = 1
{box(dim, [0., 0., 0.], [5., *thick, 2.2], [50, *([2] * (dim - 2)), 22])}
{body(dim, [0., 0., 0.], [1., *thick, 2.], material=SAND)}
{boundaries(base=("clamp", [up + "_min"]), sides=("roller", sides),
            top=("free", [up + "_max"]))}
subsection Initial state
  set Stress        = geostatic
  set Surface level = 2
  set K0            = 0.5
end
subsection Time step
  set CFL = 0.8
end
subsection Output
  set Interval = 0
end
"""


MATERIAL = "Materials/sand/"
variants = {
    "default": [],
    **{f"gamma {g:g}": [MATERIAL + f"Fluidity={g}"] for g in (1, 1e3, 1e6)},
    **{f"N {n:g}": [MATERIAL + f"Perzyna exponent={n}"] for n in (.5, 2, 10)},
    **{f"E {e:g}": [MATERIAL + f"Young modulus={e}"] for e in (1e5, 1e7)},
    "gamma 1e6, N 0.5": [MATERIAL + "Fluidity=1e6",
                         MATERIAL + "Perzyna exponent=0.5"],
    "gamma 1e6, N 10": [MATERIAL + "Fluidity=1e6",
                        MATERIAL + "Perzyna exponent=10"],
    "reset": [MATERIAL + "Separation=reset"],
    "capped": [MATERIAL + "Separation=capped"],
    "FLIP": ["Scheme/Velocity update=FLIP"],
}
cases = []
for dim in (2,) if IS_DEBUG else (2, 3):
    cases += [(f"{dim}D {name}", wall(dim), settings)
              for name, settings in variants.items()]
    for n in (1, 3, 9, 16) if dim == 2 else (1, 8, 16):
        cases.append((f"{dim}D {n} points", wall(dim),
                      [f"Points/body/Points per cell={n}"]))
if IS_DEBUG:
    cases = cases[:4]
else:
    # The stiffest one takes ten times the steps.
    cases.append(("2D E 1e8", wall(2), [MATERIAL + "Young modulus=1e8"]))
    cases.append(("2D unstructured", INPUTS / "wall_2d.prm",
                  ["Time step/CFL=0.8", "Output/Interval=0"]))
    cases.append(("3D unstructured", INPUTS / "wall.prm",
                  ["Time step/CFL=0.8", "Output/Interval=0",
                   "Mesh/File=meshes/wall_coarse.msh"]))

for name, text, settings in cases:
    result = run(text, *settings)
    if result.exit_code != 0:
        checks.that(False, name, result.text[-1500:])
        continue
    fastest = max(result["max_speed"])
    print(f"{name}: front {result.last('front'):.2f} m, fastest point "
          f"{fastest:.1f} m/s")
    checks.that(is_finite(result), f"{name}: finite")
    # Free fall from the top gives sqrt(2 g 2 m) = 6.3 m/s.
    checks.that(fastest < 20., f"{name}: no blow-up", f"{fastest} m/s")
    checks.that(result.last("kinetic_energy") + result.last("potential_energy")
                < result["potential_energy"][0], f"{name}: energy falls")
checks.exit()
