"""A block on a rough incline."""

import math

import numpy
from plotting.convergence import line_style

from .suite import boxes

TITLE = "g: block on a rough incline"

GRAVITY, END, RAMP = 9.81, .5, .1


def block(suite, dim, kind, degrees, friction):
    """The run at an angle with a coefficient of friction."""
    angle = math.radians(degrees)
    gravity = [GRAVITY * math.sin(angle), *[0.] * (dim - 2),
               -GRAVITY * math.cos(angle)]
    return suite.run(
        f"incline_{dim}d", f"{kind}_{degrees:g}_friction_{friction:g}", {
            "Body force/Gravity": boxes(*gravity),
            "Mesh/Cells": kind,
            "Points/block/Points per cell":
            8 if dim == 3 and kind == "hypercubes" else 4,
            "Boundary conditions/floor/Friction coefficient": friction})


def acceleration(degrees, friction):
    """Of a rigid block that slides [m/s^2]."""
    angle = math.radians(degrees)
    return GRAVITY * (math.sin(angle) - friction * math.cos(angle))


def path(degrees, friction, time):
    """Way of a rigid block whose gravity grows in RAMP: the double integral of
    min(1, t/RAMP)."""
    after = numpy.maximum(time - RAMP, 0.)
    return acceleration(degrees, friction) * (
        numpy.minimum(time, RAMP)**3 / (6 * RAMP) + RAMP * after / 2 +
        after**2 / 2)


def slid(run):
    """Way of the centre of mass over time."""
    return run.table["center_x"] - run.table["center_x"][0]


SLIDING = ((30., .3), (45., .5))
STICKING = (15., .6)


def verify(suite):
    suite.text(r"""
A block (0.4 m long, 0.2 m high, E = 10 MPa, $\nu$ = 0, 1500 kg/m³) on a wall with
Coulomb friction (T34). Rigid, it slides with
$a = g (\sin\theta - \mu \cos\theta)$ where $\tan\theta > \mu$, and stays otherwise.
Gravity grows from zero in 0.1 s, as put on at once it would make the block jump; the
closed form is the double integral of $a \min(1, t/0.1)$. The block that stays is sheared
by $\rho g h^2 \sin\theta / 3G$ in the mean, 0.01 mm; what it moves after 0.2 s is
drift.
""")
    rows = []
    kinds = ("simplices",) if suite.quick else ("simplices", "hypercubes")
    for dim in (2, 3):
        for kind in kinds:
            name = f"{dim}D, {kind}"
            for degrees, friction in SLIDING[:1 if suite.quick else 2]:
                run = block(suite, dim, kind, degrees, friction)
                time = run.table["time"]
                ratio = slid(run)[-1] / path(degrees, friction, time[-1])
                # The slope of the speed after the ramp.
                late = time > 2 * RAMP
                measured = 2 * numpy.polyfit(time[late], slid(run)[late], 2)[0]
                rows.append([name, f"{degrees:g}", f"{friction:g}", measured,
                             acceleration(degrees, friction),
                             f"{100 * (ratio - 1):.3f} %"])
                suite.check(f"{name}, {degrees:g} degrees: way over that of a rigid "
                            "block", ratio, .995, 1.005)
            run = block(suite, dim, kind, *STICKING)
            moved = numpy.ptp(slid(run)[run.table["time"] > 2 * RAMP])
            rows.append([name, *map("{:g}".format, STICKING), "stays", "stays",
                         f"{moved:.1e} m"])
            suite.check(f"{name}: drift of the block that stays [m]", moved,
                        most=2e-6)
    suite.table(["case", "incline [degrees]", "friction", "acceleration [m/s²]",
                 "rigid block", "way, or drift"], rows, digits=5)
    if suite.quick:
        return

    def draw(panel):
        times = numpy.linspace(0., END, 100)
        for index, (degrees, friction) in enumerate(SLIDING + (STICKING,)):
            style = line_style(index)
            run = block(suite, 2, "simplices", degrees, friction)
            exact = (path(degrees, friction, times)
                     if math.tan(math.radians(degrees)) > friction else 0 * times)
            panel.plot(times, exact, color=style["color"], linewidth=1.,
                       label=f"{degrees:g} degrees, friction {friction:g}")
            panel.plot(run.table["time"][::4], slid(run)[::4], linestyle="",
                       marker=style["marker"], color=style["color"])
        panel.set_xlabel("time [s]")
        panel.set_ylabel("way of the centre of mass [m]")
        panel.legend(fontsize=9)
    suite.figure("incline", "Way of the block: runs in 2D (points) and rigid block "
                 "(lines)", draw)
