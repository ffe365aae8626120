"""scripts/study.py: a study with a known answer, a second call that runs nothing
again, messages for wrong files; and its orders, of values with a known order."""

import csv
import os
import pathlib
import subprocess
import sys

from _program import SOURCE_DIR, Checks, Folder

sys.path.insert(0, str(SOURCE_DIR / "scripts"))
from studies.orders import estimate, observed_orders  # noqa: E402

checks = Checks()

# Values 3 + 2 h^1.5 on levels of unequal ratio: order and limit are exact.
sizes = [1., .5, .2]
values = [3 + 2 * h**1.5 for h in sizes]
found = estimate(sizes, values)
checks.that(abs(found.order - 1.5) < 1e-9, "order", str(found))
checks.that(abs(found.extrapolated - 3) < 1e-9, "limit", str(found))
checks.that(abs(found.gci - 1.25 * (values[-1] - 3) / values[-1]) < 1e-9,
            "grid convergence index", str(found))
checks.that(not estimate(sizes, [1., 2., 1.5]).is_monotone, "no limit")
checks.that(found.is_credible and not estimate(
    sizes, [3 + h**.2 for h in sizes]).is_credible, "sizes too coarse")
checks.that(all(abs(order - 1.5) < 1e-9 for order in observed_orders(
    sizes, [value - 3 for value in values])), "orders of errors")

STUDY = """
title = "A falling block"
input = "fall.prm"
[[levels]]
size = 0.1
settings = { "Time step/Fixed step" = 0.01 }
[[levels]]
size = 0.05
settings = { "Time step/Fixed step" = 0.005 }
[[vary]]
name = "points"
entry = "Points/body/Points per cell"
values = [1, 4]
[constants]
g = 10.0
[[observables]]
name = "fall"
value = "center_y[0] - center_y"
exact = "g*t**2/2"
"""
INPUT = """
set Dimension = 2
set End time  = 0.1
subsection Materials
  set Names = block
  subsection block
    set Law           = linear elastic
    set Young modulus = 1e4
  end
end
subsection Mesh
  set Subdivisions = 4, 4
end
subsection Points
  subsection body
    set Material     = block
    set Lower corner = 0.25, 0.5
    set Upper corner = 0.75, 1
  end
end
subsection Boundary conditions
  subsection walls
    set Boundaries = x_min, x_max, y_min, y_max
  end
end
subsection Body force
  set Gravity = 0, -10
end
subsection Time step
  set Type = fixed
end
"""


def study(folder):
    return subprocess.run(
        [sys.executable, SOURCE_DIR / "scripts" / "study.py", "fall.toml",
         "--output", "out", "--program", os.environ["MPM_PROGRAM"]],
        cwd=folder.path, capture_output=True, text=True, check=False,
        stdin=subprocess.DEVNULL)


with Folder() as folder:
    file = pathlib.Path(folder.path / "fall.toml")
    file.write_text(STUDY)
    (folder.path / "fall.prm").write_text(INPUT)
    result = study(folder)
    checks.that(result.returncode == 0 and result.stderr.count("running") == 4,
                "first call", str(result))
    if result.returncode == 0:
        with open(folder.path / "out" / "study.csv", encoding="utf8") as table:
            rows = list(csv.DictReader(table))
        # Symplectic Euler falls g t dt/2 too far: first order in dt.
        for row, step in zip(rows, (.01, .005, .01, .005)):
            error = 10 * .1 * step / 2
            checks.that(abs(float(row["error"]) - error) < 1e-9, "error",
                        str(row))
        checks.that(len(rows) == 4 and all(
            abs(float(row["order"]) - 1) < 1e-5 for row in rows[1::2]),
            "orders in the table", str(rows))
        checks.that({"study.md", "study.png"} <= set(
            path.name for path in (folder.path / "out").iterdir()), "files",
            str(folder.files()))

    again = study(folder)
    checks.that(again.returncode == 0 and "running" not in again.stderr,
                "second call", str(again))
    file.write_text(STUDY.replace("values = [1, 4]", "values = [1, 3]"))
    changed = study(folder)
    checks.that(changed.returncode == 0 and
                changed.stderr.count("running") == 2, "changed study",
                str(changed))
    for text, message in (("center_y[0] - center_y", "center_w"),
                          ("[[vary]]", "[[variants]]"),
                          ('input = "fall.prm"', "")):
        file.write_text(STUDY.replace(text, message))
        wrong = study(folder)
        checks.that(wrong.returncode == 1 and "Traceback" not in wrong.stderr,
                    f"'{message}' instead of '{text}'", str(wrong))
checks.exit()
