"""Columns of grains that collapse in plane strain, as in laboratory channels."""

import dataclasses
import math

import numpy

from .suite import boxes

GRAVITY, DENSITY, WIDTH = 9.81, 1500., .1
FLUIDITY = 1e4
# Initial pressure is at most 1 % of the bulk modulus: E over that of the weight.
STIFFNESS, POISSON = 120., .3


@dataclasses.dataclass
class Column:
    """A column: height over width, friction angle [degrees], cells over the width;
    settings: further entries."""
    aspect: float
    angle: float
    n_cells: int = 16
    averaging: str = "nodes"
    settings: dict = dataclasses.field(default_factory=dict)

    @property
    def height(self):
        return self.aspect * WIDTH

    @property
    def time(self):
        """The time of free fall."""
        return math.sqrt(self.height / GRAVITY)

    def entries(self):
        """What the input needs for this column: by dimensions, the same in units
        of height, gravity and density."""
        size = WIDTH / self.n_cells
        n_along = math.ceil((1 + 4 * self.aspect**(2 / 3)) * self.n_cells)
        n_up = round(self.aspect * self.n_cells) + 2
        young = STIFFNESS * DENSITY * GRAVITY * self.height
        wave_speed = math.sqrt(young / DENSITY * (1 - POISSON) /
                               ((1 + POISSON) * (1 - 2 * POISSON)))
        return {
            "End time": 7 * self.time,
            "Mesh/Upper corner": boxes(n_along * size, n_up * size),
            "Mesh/Subdivisions": boxes(n_along, n_up),
            "Materials/sand/Young modulus": young,
            "Materials/sand/Friction angle": self.angle,
            "Points/column/Upper corner": boxes(WIDTH, self.height),
            "Initial state/Surface level": self.height,
            "Initial state/K0": 1 - math.sin(math.radians(self.angle)),
            "Scheme/Averaging": self.averaging,
            "Scheme/PIC rate": 1.35 / self.time,
            "Scheme/Pressure filter rate": .25 * wave_speed / size,
            "Output/Interval": self.time,
            "Output/Observables interval": .02 * self.time,
        } | self.settings


@dataclasses.dataclass
class Deposit:
    """What became of a column, over its width and its time of free fall."""
    run: object
    run_out: float
    height: float
    duration: float
    area: float
    kinetic: float  # at the end, over the initial potential energy


def collapse(suite, name, column):
    """Runs a column."""
    run = suite.run("collapse_2d", name, column.entries())
    table = run.table
    moved = table["front"] - table["front"][0]
    stands = numpy.argmax(moved > .99 * moved[-1])
    return Deposit(run, moved[-1] / WIDTH, table["height"][-1] / WIDTH,
                   table["time"][stands] / column.time,
                   table["area"][-1] / (WIDTH * column.height),
                   table["kinetic_energy"][-1] / table["potential_energy"][0])


def surface(run):
    """Places and heights of the surface at the end [m]."""
    profile = numpy.genfromtxt(run.folder / "profile.csv", delimiter=",",
                               names=True)
    return profile["x"], profile["height"]


def slope(place, height):
    """Angle [degrees] of the surface between a fifth and four fifths of the
    height, by least squares."""
    part = (height > .2 * height.max()) & (height < .8 * height.max())
    return math.degrees(math.atan(-numpy.polyfit(place[part], height[part], 1)[0]))
