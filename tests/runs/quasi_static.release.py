"""Damping and mass scaling. An elastic column on which gravity acts at once comes to
rest at the settlement rho g H^2/(2M) with both kinds of damping, the energy balance
closes with what damping takes, and its oscillation dies out as exp(-c t/2) under
viscous damping. With scaled mass it comes to rest at the same settlement in steps
longer by the root of the factor."""

import itertools
import math
import re

from _case import (ELASTIC, KINDS, Checks, body, box, points_per_cell, rollers, run)

checks = Checks()
DENSITY, YOUNG, GRAVITY, HEIGHT = 1000., 1e6, 9.81, 1.
# Poisson's ratio is 0: the modulus of uniaxial strain is Young's.
SETTLEMENT = DENSITY * GRAVITY * HEIGHT**2 / (2 * YOUNG)  # of the top
PERIOD = 4 * HEIGHT / math.sqrt(YOUNG / DENSITY)


def column(dim, kind, end):
    up = [.2, .2, HEIGHT] if dim == 3 else [.2, HEIGHT]
    cells = [2, 2, 10] if dim == 3 else [2, 10]
    return f"""
set Dimension = {dim}
set End time  = {end}
{box(dim, [0.] * dim, up, cells, kind)}
{body(dim, [0.] * dim, up, points_per_cell(dim, kind),
      material=ELASTIC.format(density=DENSITY, young=YOUNG, poisson=0))}
{rollers(dim)}
subsection Output
  set Observables interval = {PERIOD / 200}
end
"""


def settled(result, dim):
    """Settlement of the centre of mass over that of the closed form, 2/3 of the
    top's for u = rho g (H z - z^2/2)/M."""
    centre = "center_" + "xyz"[dim - 1]
    return (result[centre][0] - result.last(centre)) / (2 / 3 * SETTLEMENT)


for dim, kind in itertools.product((2, 3), KINDS):
    name = f"{dim}D, {kind}"
    ends = {}
    for kind_of_damping, settings in {
            "local": ["Damping/Damping coefficient=0.7"],
            "viscous": [f"Damping/Damping rate={4 * math.pi / PERIOD}"],
            "scaled": ["Damping/Damping coefficient=0.7", "Scheme/Mass scaling=16",
                       f"End time={40 * PERIOD}",
                       f"Output/Observables interval={PERIOD}"]}.items():
        if kind_of_damping == "scaled" and kind != "simplices":
            continue
        type_of = "local" if kind_of_damping == "scaled" else kind_of_damping
        result = run(column(dim, kind, 10 * PERIOD), f"Damping/Type={type_of}",
                     *settings)
        if result.exit_code != 0:
            checks.that(False, f"{name}, {kind_of_damping}: runs", result.text)
            continue
        ends[kind_of_damping] = result
        ratio = settled(result, dim)
        print(f"{name}, {kind_of_damping}: settlement {ratio - 1:+.2e}, kinetic "
              f"energy {result.last('kinetic_energy'):.1e} J, closure "
              f"{result.last('closure'):.1e}, dt {result['dt'][3]:.2e} s", flush=True)
        # Finite strain: p = -K ln J, and weights of the moved points.
        strain = DENSITY * GRAVITY * HEIGHT / YOUNG
        checks.that(abs(ratio - 1.) < strain, f"{name}, {kind_of_damping}: settlement",
                    str(ratio))
        checks.that(result.last("kinetic_energy") <
                    1e-5 * result.last("elastic_energy"),
                    f"{name}, {kind_of_damping}: at rest")
        # Gravity gives twice what is stored, and damping takes the other half.
        checks.that(abs(result.last("damping") / result.last("elastic_energy") - 1.)
                    < .05, f"{name}, {kind_of_damping}: energy taken",
                    str(result.last("damping")))
        error = max(map(abs, result["closure"])) * result["potential_energy"][0]
        checks.that(error < .05 * result.last("elastic_energy"),
                    f"{name}, {kind_of_damping}: closure", str(error))
    if "scaled" in ends and "local" in ends:
        # Steps are cut to meet the rows; the limit itself is in the report.
        limits = [float(re.search(r"stability limit +(\S+) s", result.text)[1])
                  for result in (ends["scaled"], ends["local"])]
        print(f"{name}: limit larger by {limits[0] / limits[1]}, in the mean "
              f"{4 * ends['local'].last('step') / ends['scaled'].last('step')}")
        checks.that(abs(limits[0] / limits[1] - 4.) < .01, f"{name}: limit",
                    str(limits))
        checks.that(ends["scaled"].last("step") < 1.1 * ends["local"].last("step"),
                    f"{name}: steps", "four times the time in as many steps")
        checks.that(abs(settled(ends["scaled"], dim) / settled(ends["local"], dim) - 1)
                    < 1e-3, f"{name}: the same at rest")

# Underdamped: the lowest peaks follow each other after a period.
RATE = .1 * 4 * math.pi / PERIOD
result = run(column(2, "simplices", 3 * PERIOD), "Damping/Type=viscous",
             f"Damping/Damping rate={RATE}", "Scheme/Velocity update=FLIP")
amplitude = [y - (result["center_y"][0] - 2 / 3 * SETTLEMENT)
             for y in result["center_y"]]
peaks = [max(map(abs, amplitude[i:i + 41])) for i in (180, 380)]
decay = math.log(peaks[0] / peaks[1]) / (RATE * PERIOD / 2)
print(f"viscous: rate of decay over c/2: {decay}")
checks.that(abs(decay - 1.) < .05, "rate of decay", str(decay))

refused = run(column(2, "simplices", 1), "Scheme/Mass scaling=10")
checks.that(refused.exit_code == 1 and "Scheme/Mass scaling = 10" in refused.text,
            "mass scaling without damping", refused.text)
checks.exit()
