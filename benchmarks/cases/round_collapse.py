"""Collapse of round columns, a quarter of them in 3D, against experiments."""

import dataclasses
import math

import numpy
from plotting.convergence import line_style

from .collapse import DENSITY, GRAVITY, POISSON, STIFFNESS, slope
from .laws_of_collapse import (LAJEUNESSE_ROUND, LUBE_ROUND, deviation,
                               draw_laws, table_of_laws)
from .suite import boxes

TITLE = "Round columns in 3D"

LAWS = [LUBE_ROUND, LAJEUNESSE_ROUND]
ASPECTS = [.5, 1., 2., 4., 8.]
# Friction angle [degrees] and cells over the radius; the tallest columns are too dear on
# the finer mesh.
SERIES = {(22., 10): ASPECTS[:3], (30., 10): ASPECTS[:3], (30., 7): ASPECTS}
EXTENT = .1  # cells whose centres are nearer to the axis are filled [m]


@dataclasses.dataclass
class RoundColumn:
    """A round column of cubes: height over radius, friction angle [degrees], cells
    over the radius; settings: further entries."""
    aspect: float
    angle: float
    n_cells: int = 10
    n_points: int = 1
    settings: dict = dataclasses.field(default_factory=dict)

    @property
    def size(self):
        return EXTENT / self.n_cells

    @property
    def rows(self):
        """Number of cells in each row."""
        centres = numpy.arange(self.n_cells) + .5
        return [int((centres**2 + centre**2 < self.n_cells**2).sum())
                for centre in centres]

    @property
    def radius(self):
        """Of the circle with the area of the filled cells."""
        return math.sqrt(4 / math.pi * sum(self.rows)) * self.size

    @property
    def n_up(self):
        """Number of cells over the height."""
        return round(self.aspect * self.radius / self.size)

    @property
    def height(self):
        return self.n_up * self.size

    @property
    def true_aspect(self):
        return self.height / self.radius

    @property
    def time(self):
        """The time of free fall."""
        return math.sqrt(self.height / GRAVITY)

    def entries(self):
        """What the input needs for this column."""
        size = self.size
        reach = 2. * self.true_aspect if self.aspect < 1.5 else (
            2.4 * self.true_aspect**.5)
        n_out = math.ceil((1 + reach) * self.n_cells)
        young = STIFFNESS * DENSITY * GRAVITY * self.height
        wave_speed = math.sqrt(young / DENSITY * (1 - POISSON) /
                               ((1 + POISSON) * (1 - 2 * POISSON)))
        entries = {
            "End time": 5 * self.time,
            "Mesh/Upper corner": boxes(n_out * size, n_out * size,
                                       (self.n_up + 1) * size),
            "Mesh/Subdivisions": boxes(n_out, n_out, self.n_up + 1),
            "Materials/sand/Young modulus": young,
            "Materials/sand/Friction angle": self.angle,
            "Points/Names": ", ".join(f"row{row + 1}"
                                      for row in range(self.n_cells)),
            "Initial state/Surface level": self.height,
            "Initial state/K0": 1 - math.sin(math.radians(self.angle)),
            "Scheme/PIC rate": 1.35 / self.time,
            "Scheme/Pressure filter rate": .25 * wave_speed / size,
            "Output/Interval": .1 * self.time,
        }
        for row, n_filled in enumerate(self.rows):
            entries |= {
                f"Points/row{row + 1}/Material": "sand",
                f"Points/row{row + 1}/Lower corner": boxes(row * size, 0., 0.),
                f"Points/row{row + 1}/Upper corner": boxes(
                    (row + 1) * size, n_filled * size, self.height),
                f"Points/row{row + 1}/Points per cell": self.n_points}
        return entries | self.settings


def quantile_radius(run, frame):
    """Distance from the axis within which 99.9 % of the points are."""
    place = run.points(frame)["position"]
    return numpy.quantile(numpy.hypot(place[:, 0], place[:, 1]), .999)


def surface(run, size):
    """Radii of rings and the heights of the surface over them [m]."""
    place = run.points(len(run.frames) - 1)["position"]
    radius = numpy.hypot(place[:, 0], place[:, 1])
    rings = numpy.arange(0., radius.max() + size, size)
    ring = numpy.digitize(radius, rings) - 1
    return rings[:-1] + .5 * size, numpy.array(
        [numpy.quantile(place[ring == i, 2], .98) if (ring == i).any() else 0.
         for i in range(len(rings) - 1)])


def collapse(suite, name, column):
    """Runs a column; run-out and height over its radius, time over that of free
    fall, kinetic energy at the end, front over time."""
    run = suite.run("collapse_3d", name, column.entries())
    start = quantile_radius(run, 0)
    front = numpy.array([quantile_radius(run, frame) - start
                         for frame in range(len(run.frames))])
    times = numpy.array([time for time, _ in run.frames]) / column.time
    stands = numpy.interp(.99 * front[-1], front, times)
    _, heights = surface(run, column.size)
    return {"run": run, "run_out": front[-1] / column.radius,
            "height": heights[0] / column.radius, "duration": stands,
            "kinetic": (run.table["kinetic_energy"][-1] /
                        run.table["potential_energy"][0])}


def validate(suite):
    if suite.quick:
        return
    suite.text(r"""
Cylinders of the radius $R$ and the height $H = aR$ on a rough floor; a quarter is
computed between planes of symmetry, on a box of tetrahedra.
""")
    table_of_laws(suite, LAWS)
    suite.text(r"""
Lube: *J. Fluid Mech.* 508 (2004) 175, sand, salt, sugar, rice and others. Lajeunesse:
*Phys. Fluids* 17 (2005) 103302 and *Phys. Fluids* 16 (2004) 2371, glass beads, factors
read off the lines of their figures. The cylinder is one of cubes (of 5 tetrahedra) whose
centres are within 10 (or 7) cells of the axis; $R$ is the radius of a circle of this area, and $a$
the true ratio of height to it. One point per tetrahedron, `Scheme/Averaging = nodes`,
the cone of the paper (a mean of triaxial compression and extension). Front:
within it are 99.9 % of the points. Slope: of the surface of the deposit between a fifth and
four fifths of its height.
""")
    found, rows = {}, []
    for (angle, n_cells), aspects in SERIES.items():
        found[angle, n_cells] = []
        for aspect in aspects:
            column = RoundColumn(aspect, angle, n_cells)
            name = f"{angle:g}_degrees_{n_cells}_cells_{aspect:g}"
            deposit = collapse(suite, name, column)
            found[angle, n_cells].append(
                deposit | {"aspect": column.true_aspect})
            rows.append(row(f"{angle:g}°, {n_cells} cells", column, deposit))
        suite.check(f"{angle:g} degrees, {n_cells} cells: largest kinetic "
                    "energy at the end over the initial potential energy",
                    max(deposit["kinetic"] for deposit in found[angle, n_cells]),
                    most=2e-3)
    suite.table(header(""), rows)

    def draw(left, right):
        for axes, quantity, label in (
                (left, "run_out", "(run-out - R) / R"),
                (right, "height", "final height / R")):
            draw_laws(axes, LAWS, quantity, ASPECTS)
            for index, ((angle, n_cells), deposits) in enumerate(
                    found.items()):
                axes.plot([deposit["aspect"] for deposit in deposits],
                          [deposit[quantity] for deposit in deposits],
                          label=f"{angle:g}°, {n_cells} cells",
                          **line_style(index) | {"linewidth": 0.})
            axes.set_ylabel(label)
        left.set_yticks([.5, 1., 2., 4.], [".5", "1", "2", "4"])
        right.set_yticks([.4, .5, .7, 1.], [".4", ".5", ".7", "1"])
        left.legend(fontsize=9)
    suite.figure("round_laws", "Run-out and final height over the aspect ratio: "
                 "runs (marks) and laws of experiments (grey)", draw, 2)

    suite.text("What this depends on, for a = 1 and 30°:")
    rows = []
    for label, changes in (
            ("10 cells, as above", {}), ("14 cells", {"n_cells": 14}),
            ("4 points per tetrahedron", {"n_points": 4}),
            ("no averaging, 4 points per tetrahedron",
             {"n_points": 4, "settings": {"Scheme/Averaging": "none"}}),
            ("cone of triaxial extension",
             {"settings": {"Materials/sand/Cone slope": "triaxial extension"}}),
            ("smooth floor",
             {"settings": {"Boundary conditions/floor/Type": "roller"}})):
        column = RoundColumn(1., 30., **changes)
        rows.append(row(label, column, collapse(
            suite, f"variant_{label.replace(' ', '_').replace(',', '')}",
            column)))
    suite.table(header("a = 1, 30°"), rows)
    suite.text("""
Run-outs of all but the tallest are too short, and grow with the number of cells: the
toe of a round deposit is thinner than a cell over much of its length, and on a rough
floor a layer of one cell cannot slide. They are to be read together with the columns in
plane strain above, on finer meshes. Heights are those of points, which lie up to half a
cell, 0.05 R, below the surface.
""")


def row(label, column, deposit):
    """What a run gave, and how much more than the laws."""
    return [label, column.true_aspect, deposit["run_out"],
            *[deviation(deposit["run_out"], law.run_out(column.true_aspect))
              for law in LAWS], deposit["height"],
            *[deviation(deposit["height"], law.height(column.true_aspect))
              for law in LAWS], deposit["duration"],
            f"{slope(*surface(deposit['run'], column.size)):.1f}°"]


def header(first):
    return [first, "a", "run-out", "to Lube", "to Lajeunesse", "height",
            "to Lube", "to Lajeunesse", "time", "slope"]
