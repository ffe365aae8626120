"""Slopes of deposits against the friction angle."""

import math

from plotting.convergence import line_style

from .collapse import Column, collapse, slope, surface

TITLE = "Angle of repose"

ANGLES = [20., 25., 30., 35., 40.]


def validate(suite):
    if suite.quick:
        return
    suite.text(r"""
A column, twice as high as wide, spreads on a rough floor in plane strain; measured is
the slope of what remains, by least squares between a fifth and four fifths of its height.
*Fast*: the gate vanishes at once, the fluidity is 10⁴/s. *Slow*: the fluidity is 5/s and
the PIC rate 50/s, so that viscosity lets the column sink with little inertia, for 25
$\sqrt{H/g}$. Measured angles of repose are those of slow heaps. The
cone is matched to plane strain, $m = \sqrt3 \sin\varphi$; with it a slope without
cohesion stands up to $\varphi$ if its stresses can choose (Mohr and Coulomb), while a
long layer that flows at constant volume stops at $\arctan(m/\sqrt3) = \arctan
\sin\varphi$ ([verification](../verification/README.md), f). Slow heaps are expected at
the lower of the two or above; inertia makes deposits flatter.
""")
    rows, slopes = [], {"fast": [], "slow": []}
    for angle in ANGLES:
        column = Column(2., angle, 10)
        slow = Column(2., angle, 10, settings={
            "Materials/sand/Fluidity": 5., "End time": 25 * column.time,
            "Scheme/PIC rate": 50.,
            "Output/Observables interval": .2 * column.time})
        for name, one in (("fast", column), ("slow", slow)):
            deposit = collapse(suite, f"repose_{name}_{angle:g}", one)
            slopes[name].append(slope(*surface(deposit.run)))
        rows.append([f"{angle:g}°", f"{flowing(angle):.1f}°",
                     *[f"{found[-1]:.1f}°" for found in slopes.values()]])
        suite.check(f"{angle:g} degrees: slow slope below the friction angle "
                    "(by 2 degrees)", slopes["slow"][-1], most=angle + 2)
    suite.table(["friction angle", "arctan sin", "fast", "slow"], rows)
    below = [flowing(angle) - found
             for angle, found in zip(ANGLES, slopes["slow"])]
    suite.text(f"""
Slow heaps stop {min(below):.1f}° to {max(below):.1f}° below the slope of a flowing layer, by
more for large angles, whose heaps keep a rounded top. Fast collapses leave about half of it.
""")

    def draw(axes):
        axes.plot(ANGLES, ANGLES, "k--", linewidth=1., label="friction angle")
        axes.plot(ANGLES, [flowing(angle) for angle in ANGLES], "k:",
                  linewidth=1., label="layer that flows, arctan sin")
        for index, (name, found) in enumerate(slopes.items()):
            axes.plot(ANGLES, found, label=name, **line_style(index))
        axes.set_xlabel("friction angle [degrees]")
        axes.set_ylabel("slope of the deposit [degrees]")
        axes.legend(fontsize=9)
    suite.figure("repose", "Slope of the deposit over the friction angle", draw)


def flowing(angle):
    """Slope on which a long layer stops [degrees]."""
    return math.degrees(math.atan(math.sin(math.radians(angle))))
