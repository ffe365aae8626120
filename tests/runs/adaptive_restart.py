"""A run on an adaptive mesh that was interrupted and continued leaves the same
files, bit for bit: the mesh comes back as it was. On other numbers of processes
it goes on up to round-off."""

import os
import signal

from _case import KINDS, Folder
from _restart import (IS_DEBUG, Case, agree, checks, column, interrupted, same,
                      uninterrupted)

ADAPTIVE = """
subsection Adaptive mesh
  set Names         = surface, slide
  set Maximum level = 1
  set Interval      = 7
  subsection surface
    set Type = free surface
  end
  subsection slide
    set Type = shear
  end
end
"""


def case_of(dim, kind):
    return column(dim, kind) + ADAPTIVE


for dim in (2,) if IS_DEBUG else (2, 3):
    for kind in KINDS:
        name = f"{dim}D, {kind}"
        averages = (("Scheme/Averaging=nodes",) if kind == "simplices" and dim == 2
                    else ())
        reference = uninterrupted(case_of(dim, kind), averages)
        with Folder() as folder:
            case = Case(folder, case_of(dim, kind), averages)
            code = interrupted(case)
            checks.that(code == 3, f"{name}: interrupted", str(code))
            case.run("--resume", "out")
            same(f"{name}: resumed", case.results(), reference)
            performance = case.manifest()["performance"]
            checks.that(performance["adaptations"] > 5, f"{name}: adaptations",
                        str(performance))
        if not os.environ.get("MPM_MPIEXEC"):
            continue
        with Folder() as folder:
            case = Case(folder, case_of(dim, kind), ranks=2)
            case.run(*case.start())
            on_two = case.results()
        with Folder() as folder:
            case = Case(folder, case_of(dim, kind), ranks=2)
            interrupted(case)
            case.run("--resume", "out")
            same(f"{name}, two processes: resumed", case.results(), on_two)
        if not IS_DEBUG and (dim == 2) == (kind == "simplices"):
            continue  # restart.py has these two, without changes of the mesh
        with Folder() as folder:
            case = Case(folder, case_of(dim, kind))
            interrupted(case)
            case.ranks = 3
            case.stop(signal.SIGTERM, "--resume", "out", rows=16)
            case.ranks = 2
            case.run("--resume", "out")
            agree(f"{name}, one, three, two processes", case.results(), on_two)
checks.exit()
