"""Runs small cases for other tests, which import this file."""

import csv
import json
import math
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "scripts"))
from _program import INPUTS, Checks, Folder  # noqa: E402,F401

IS_DEBUG = os.environ.get("MPM_BUILD_TYPE") == "Debug"
DIMENSIONS = (2,) if IS_DEBUG else (2, 3)  # 3D takes long in Debug

SAND = """
  set Law             = Drucker-Prager viscoplastic
  set Density         = 1500
  set Young modulus   = 1e6
  set Poisson ratio   = 0.3
  set Friction angle  = 30
  set Fluidity        = 50
"""

ELASTIC = """
  set Law             = linear elastic
  set Density         = {density}
  set Young modulus   = {young}
  set Poisson ratio   = {poisson}
"""


KINDS = ("simplices", "hypercubes")

# Settings that put wall_2d.prm on squares of 0.05 m.
SQUARES = ["Mesh/Source=box", "Mesh/Cells=hypercubes", "Mesh/Lower corner=0, 0",
           "Mesh/Upper corner=4, 2.2", "Mesh/Subdivisions=80, 44",
           "Points/wall/Shape=box", "Points/wall/Lower corner=0, 0",
           "Points/wall/Upper corner=1, 2", "Scheme/Pressure filter rate=300"]


def box(dim, lower, upper, subdivisions, cells="simplices"):
    """The section Mesh of a box."""
    return f"""
subsection Mesh
  set Source       = box
  set Cells        = {cells}
  set Lower corner = {vector(lower[:dim])}
  set Upper corner = {vector(upper[:dim])}
  set Subdivisions = {vector(subdivisions[:dim])}
end"""


def vector(numbers):
    return ", ".join(str(number) for number in numbers)


def points_per_cell(dim, cells):
    """A usual number."""
    return 8 if dim == 3 and cells == "hypercubes" else 4


def body(dim, lower, upper, points_per_cell=4, material=SAND):
    """The sections Materials and Points of a box full of one material."""
    return f"""
subsection Materials
  set Names = sand
  subsection sand
  {material}
  end
end
subsection Points
  set Names = body
  subsection body
    set Material        = sand
    set Shape           = box
    set Lower corner    = {vector(lower[:dim])}
    set Upper corner    = {vector(upper[:dim])}
    set Points per cell = {points_per_cell}
  end
end"""


def levels(expression, maximum, interval=1):
    """The section Adaptive mesh with levels by place and time."""
    return f"""
subsection Adaptive mesh
  set Names                 = somewhere
  set Maximum level         = {maximum}
  set Interval              = {interval}
  set Interval displacement = 0
  set Buffer layers         = 0
  set Kept layers           = 0
  subsection somewhere
    set Type  = region
    set Level = {expression}
  end
end
"""


def boundaries(**conditions):
    """The section Boundary conditions: type=(names of boundaries)."""
    text = "\nsubsection Boundary conditions\n"
    text += f"  set Names = {', '.join(conditions)}\n"
    for name, (kind, names) in conditions.items():
        text += f"""  subsection {name}
    set Boundaries = {', '.join(names)}
    set Type       = {kind}
  end
"""
    return text + "end\n"


def rollers(dim):
    """Rollers on all sides but the open top."""
    names = ["x_min", "x_max", "y_min", "y_max", "z_min", "z_max"][:2 * dim]
    return boundaries(walls=("roller", names[:-1]), top=("free", names[-1:]))


def escaping_body():
    """A case without walls: the body falls out of the mesh."""
    return f"""
set Dimension = 2
set End time  = 2
{box(2, [0., 0.], (1., 1.), (8, 8))}
{body(2, [.25, .25], (.75, .75),
      material=ELASTIC.format(density=1000, young=1e5, poisson=.3))}
{boundaries(all=("free", ["x_min", "x_max", "y_min", "y_max"]))}
"""


class Result:
    """The table of observables of a run, its manifest, and what it said."""

    def __init__(self, process, folder):
        self.exit_code = process.returncode
        self.text = process.stdout + process.stderr
        self.errors = [line for line in process.stderr.splitlines()
                       if "mpm_granular: error" in line]
        self.columns = {}
        manifest = folder / "manifest.json"
        self.manifest = (json.loads(manifest.read_text(encoding="utf8"))
                         if manifest.exists() else {})
        table = folder / "observables.csv"
        if table.exists():
            with open(table, encoding="utf8") as file:
                for row in csv.DictReader(file):
                    for name, value in row.items():
                        self.columns.setdefault(name, []).append(float(value))

    def __getitem__(self, column):
        return self.columns[column]

    def last(self, column):
        return self.columns[column][-1]

    def at(self, time, column):
        """The value at the row nearest to a time."""
        times = self.columns["time"]
        index = min(range(len(times)), key=lambda i: abs(times[i] - time))
        return self.columns[column][index]


def on_ranks(ranks):
    """What to put before the program to run it on several processes."""
    return [os.environ["MPM_MPIEXEC"], "-np", str(ranks)] if ranks > 1 else []


def run(text_or_file, *settings, ranks=1):
    """Runs a text of parameters or a shipped file, with `--set` settings."""
    with Folder() as folder:
        if isinstance(text_or_file, pathlib.Path):
            file = text_or_file
        else:
            file = folder.path / "case.prm"
            file.write_text(text_or_file, encoding="utf8")
        options = [word for setting in settings for word in ("--set", setting)]
        process = folder.run(file, "--output", "out", *options,
                             before=on_ranks(ranks))
        result = Result(process, folder.path / "out")
        result.files = folder.files()
        return result


def is_finite(result):
    return all(math.isfinite(value) for column in result.columns.values()
               for value in column)
