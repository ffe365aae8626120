"""Collapse of columns in plane strain against experiments in channels."""

import numpy
from plotting.convergence import line_style

from .collapse import WIDTH, Column, collapse, surface
from .laws_of_collapse import (LAJEUNESSE_PLANE, LUBE_PLANE, deviation,
                               draw_laws, table_of_laws)

TITLE = "Columns in plane strain"

LAWS = [LUBE_PLANE, LAJEUNESSE_PLANE]
ASPECTS = [.5, 1., 2., 3., 4., 6., 8.]


def row(label, column, deposit):
    """What a run gave, and how much more than the laws."""
    return [label, deposit.run_out,
            *[deviation(deposit.run_out, law.run_out(column.aspect))
              for law in LAWS],
            deposit.height,
            *[deviation(deposit.height, law.height(column.aspect))
              for law in LAWS], deposit.duration, deposit.area]


def header(first):
    return [first, "run-out", "to Lube", "to Lajeunesse", "height", "to Lube",
            "to Lajeunesse", "time", "area"]


def check(suite, name, deposit):
    suite.check(f"{name}: area over the initial one", deposit.area, .9, 1.1)
    suite.check(f"{name}: kinetic energy at the end over the initial potential "
                "energy", deposit.kinetic, most=1e-3)


def validate(suite):
    if suite.quick:
        column = Column(1., 30., 8)
        deposit = collapse(suite, "quick", column)
        check(suite, "column", deposit)
        suite.check("column: run-out between the laws, with 20 %",
                    deposit.run_out, .8 * LUBE_PLANE.run_out(1.),
                    1.2 * LAJEUNESSE_PLANE.run_out(1.))
        suite.check("column: height between the laws, with 20 %",
                    deposit.height, .8 * LAJEUNESSE_PLANE.height(1.),
                    1.2 * LUBE_PLANE.height(1.))
        return

    suite.text(r"""
A column of the width $L$ and the height $H = aL$ between a smooth wall and a gate that
vanishes at once, on a rough floor (Lajeunesse), or half of a column that falls to both
sides (Lube). The experiments' results do not depend on size, grains or floor, as far as
they were varied, but differ between the two groups by up to a half.
""")
    table_of_laws(suite, LAWS)
    suite.text(r"""
Lube: *Phys. Rev. E* 72 (2005) 041301, sand, sugar, rice; between the two ranges of the
run-out a straight line is used here. Lajeunesse: *Phys. Fluids* 17 (2005) 103302, glass
beads with an angle of repose of 22°, which begin to slide at 27°; their papers give the
powers, and the factors are read off the lines of their figures (by 3 %), about which the
measurements scatter by 10 to 20 %. In the experiments the front is that of the
connected deposit.

Computed are columns 0.1 m wide with friction angles of 22° and 30° matched to plane
strain, 16 cells over the width, 4 points per triangle, `Scheme/Averaging = nodes`, with
E = 120 times the weight per area (p/K at most 1 %) and a fluidity of 10⁴/s (no effect of rate).
Front: behind it are 99.9 % of the mass. Time: until the run-out has reached 99 % of its
final value, over $\sqrt{H/g}$. Area: of the deposit in a side view, over the initial one.
""")
    deposits = {}
    for angle in (22., 30.):
        rows = []
        for aspect in ASPECTS:
            column = Column(aspect, angle)
            deposit = collapse(suite, f"{angle:g}_degrees_{aspect:g}", column)
            deposits[angle, aspect] = deposit
            rows.append(row(f"{aspect:g}", column, deposit))
            check(suite, f"{angle:g} degrees, a = {aspect:g}", deposit)
        suite.text(f"Friction angle {angle:g}°:")
        suite.table(header("a"), rows)
        for quantity, least in (("run_out", 3.), ("height", 1.)):
            tall = [aspect for aspect in ASPECTS if aspect >= least]
            power = numpy.polyfit(
                numpy.log(tall), numpy.log([getattr(deposits[angle, aspect],
                                                    quantity)
                                            for aspect in tall]), 1)[0]
            suite.text(f"Power of a in the {quantity.replace('_', '-')} for "
                       f"a ≥ {least:g}: {power:.2f}.")

    def draw(left, right):
        for axes, quantity, label in (
                (left, "run_out", "(run-out - L) / L"),
                (right, "height", "final height / L")):
            draw_laws(axes, LAWS, quantity, ASPECTS)
            for index, angle in enumerate((22., 30.)):
                style = line_style(index) | {"linewidth": 0.}
                axes.loglog(ASPECTS, [getattr(deposits[angle, aspect], quantity)
                                      for aspect in ASPECTS],
                            label=f"friction angle {angle:g}°", **style)
            axes.set_ylabel(label)
        ticks = [.5, 1, 2, 5, 10]
        left.set_yticks(ticks, [f"{tick:g}" for tick in ticks])
        right.set_yticks(ticks[:3], [f"{tick:g}" for tick in ticks[:3]])
        left.legend(fontsize=9)
    suite.figure("plane_laws", "Run-out and final height over the aspect ratio: "
                 "runs (marks) and laws of experiments (grey)", draw, 2)

    def draw_shapes(left, right):
        for index, aspect in enumerate((.5, 1., 2., 4., 8.)):
            colour = line_style(index)["color"]
            deposit = deposits[30., aspect]
            place, height = surface(deposit.run)
            left.plot(place / WIDTH, height / WIDTH, color=colour,
                      label=f"a = {aspect:g}")
            table = deposit.run.table
            moved = table["front"] - table["front"][0]
            right.plot(table["time"] / Column(aspect, 30.).time,
                       moved / moved[-1], color=colour)
        left.set_xlim(0., None)
        left.set_xlabel("x / L")
        left.set_ylabel("height of the deposit / L")
        left.legend(fontsize=9)
        for law, dashes in zip(LAWS, ("-", "--")):
            right.axvline(law.duration, color="0.4", linestyle=dashes,
                          linewidth=1.2, label=law.who)
        right.set_xlim(0., 5.)
        right.set_xlabel("time / sqrt(H/g)")
        right.set_ylabel("run-out / final run-out")
        right.legend(fontsize=9)
    suite.figure("plane_shapes", "Deposits, and the front over time, friction "
                 "angle 30°; grey: end of motion in experiments", draw_shapes, 2)
    variants(suite)


def variants(suite):
    """What the result for one column depends on."""
    suite.text("What this depends on, for a = 2 and 30°:")
    settings = [
        ("as above", {}, {}),
        ("8 cells over the width", {"n_cells": 8}, {}),
        ("32 cells", {"n_cells": 32}, {}),
        ("no averaging", {"averaging": "none"}, {}),
        ("no averaging, 8 cells", {"averaging": "none", "n_cells": 8}, {}),
        ("no averaging, 32 cells", {"averaging": "none", "n_cells": 32}, {}),
        ("one point per triangle", {}, {"Points/column/Points per cell": 1}),
        ("smooth floor", {}, {"Boundary conditions/floor/Type": "roller"}),
        ("cone of the paper", {}, {"Materials/sand/Cone slope": "paper"}),
        ("fluidity 100/s", {}, {"Materials/sand/Fluidity": 100.}),
        ("E four times as large", {}, {"Materials/sand/Young modulus":
                                       4 * 120 * 1500 * 9.81 * .2}),
        ("half the step", {}, {"Time step/CFL": .25}),
    ]
    rows = []
    for label, changes, entries in settings:
        column = Column(2., 30., settings=entries, **changes)
        name = label.replace(" ", "_").replace("/", "_")
        rows.append(row(label, column, collapse(suite, f"variant_{name}",
                                                column)))
    suite.table(header("a = 2, 30°"), rows)
