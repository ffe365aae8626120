"""Moving least squares in the collapse of the wall: the deposit of the other
schemes, quiet pressures with the filter, with every order of the stress update,
velocity update and wall that it is made for. What it is not made for is refused."""

import os
import pathlib
import subprocess
import sys

from _case import INPUTS, IS_DEBUG, SQUARES, Checks, Folder, Result, run

checks = Checks()
WALL = INPUTS / "wall_2d.prm"
SCHEME = "Scheme/Averaging=moving least squares"
NOISE = (pathlib.Path(os.environ["MPM_SOURCE_DIR"]) / "scripts" /
         "pressure_noise.py")

REFUSED = [(SQUARES, "on simplices only"),
           (["Scheme/Velocity update=APIC",
             "Scheme/Gradient damping rate=1000"],
            "needs another Scheme/Velocity update than APIC"),
           (["Scheme/Mass matrix=near-consistent"],
            "needs Scheme/Mass matrix = lumped; given: near-consistent"),
           (["Scheme/Position shift rate=10"],
            "Position shift rate needs Scheme/Averaging = nodes"),
           (["Adaptive mesh/Names=front"],
            "'Adaptive mesh', whose 'Names' must be empty")]
for settings, message in REFUSED:
    refused = run(WALL, SCHEME, *settings)
    checks.that(refused.exit_code == 1 and message in refused.text,
                f"refused: {settings}", refused.text[-2000:])

# The fall begins as with linear functions, other things being equal.
END = "End time=0.02" if IS_DEBUG else "End time=0.1"
FRICTION = ["Boundary conditions/base/Type=Coulomb friction",
            "Boundary conditions/base/Friction coefficient=0.5"]
for settings in ([], ["Scheme/Stress order=USL"], ["Scheme/Stress order=USF"],
                 ["Scheme/Velocity update=XPIC", "Scheme/Order=3"],
                 ["Scheme/Velocity update=FMPM", "Scheme/Order=4"], FRICTION):
    linear = run(WALL, END, "Scheme/Averaging=none", *settings)
    other = run(WALL, END, SCHEME, *settings)
    if linear.exit_code != 0 or other.exit_code != 0:
        checks.that(False, f"{settings}", other.text[-2000:])
        continue
    a, b = other.last("kinetic_energy"), linear.last("kinetic_energy")
    checks.that(abs(a - b) < .05 * b and abs(other.last("closure")) < 1e-3,
                f"{settings}", f"{a} and {b}, {other.last('closure')}")

if IS_DEBUG:
    checks.exit()
with Folder() as folder:
    process = folder.run(WALL, "--output", "out", "--set", SCHEME, "--set",
                         "Output/Interval=0.2")
    result = Result(process, folder.path / "out")
    said = subprocess.run([sys.executable, str(NOISE), str(folder.path / "out")],
                          check=True, capture_output=True, text=True).stdout
noise = [float(n) for n in said.splitlines()[-1].split()[:3]]
text = (f"front {result.last('front')}, height {result.last('height')}, "
        f"area {result.last('area')}, closure {result.last('closure')}, "
        f"noise {noise}")
print(text)
# The wall's bands (theory, section 8).
checks.that(abs(result.last("front") - 3.35) < .15 and
            abs(result.last("height") - 1.25) < .08 and
            abs(result.last("area") - 2.) < .1, "the deposit", text)
checks.that(abs(result.last("closure")) < 2e-3, "the ledger closes", text)
checks.that(max(noise) < .3, "quiet pressures", text)
checks.exit()
