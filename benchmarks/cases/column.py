"""A column under its own weight."""

import math

import numpy

from .suite import boxes

TITLE = "e: column at rest"

GRAVITY, HEIGHT, DENSITY = 9.81, 2., 1500.
BULK = 1e6 / (3 * (1 - 2 * .3))
SHEAR = 1e6 / (2 * (1 + .3))
SLOPE = 18 * .5 / (9 - .25)


def acceleration(suite, dim, layout):
    """Largest acceleration of a point in the first step over gravity."""
    name, settings = layout
    run = suite.run(f"column_{dim}d", f"first_step_{name}", settings | {
        "End time": 1e-4, "Time step/Type": "fixed",
        "Time step/Fixed step": 1e-4, "Scheme/Velocity update": "FLIP"})
    return run.table["max_speed"][-1] / (1e-4 * GRAVITY)


def settled_acceleration(suite, dim, layout):
    """The same after the stage that finds the initial equilibrium from no stress at
    all, in the first step of the run."""
    name, settings = layout
    table = suite.run(f"column_{dim}d", f"settled_{name}", settings | {
        "Initial state/Stress": "none", "Initial equilibrium/Enabled": "true",
        "End time": 1e-3}).table
    return table["max_speed"][1] / (table["dt"][1] * GRAVITY)


def settlement(suite, dim, n_cells):
    """How far the top comes down from K0 = 0.3, outside of yield, to the nearest
    state on the cone, mean over the last three periods 4 H/c of the column: the
    strain grows linearly with depth, so the top moves 3/2 as far as the centre of
    mass."""
    cells = [n_cells // 2] * (dim - 1) + [n_cells]
    run = suite.run(f"column_{dim}d", f"settlement_{n_cells}", {
        "Initial state/K0": .3, "End time": 2.5,
        "Materials/sand/Fluidity": .05,
        "Mesh/Subdivisions": boxes(*cells)})
    table = run.table
    center = table[f"center_{'xyz'[dim - 1]}"]
    period = 4 * HEIGHT / math.sqrt((BULK + 4 / 3 * SHEAR) / DENSITY)
    late = table["time"] > table["time"][-1] - 3 * period
    return 1.5 * (center[0] - numpy.average(center[late],
                                            weights=table["dt"][late]))


def expected_settlement():
    """Constant vertical stress S; yield lets p rise from (1 + 2 K0)/3 S to where
    q = 3 (S - p)/2 = m p."""
    start, end = (1 + 2 * .3) / 3, 1 / (1 + 2 / 3 * SLOPE)
    return .5 * HEIGHT * (end - start) * DENSITY * GRAVITY * HEIGHT / BULK


def verify(suite):
    suite.text(r"""
Sand between smooth walls under $\sigma_v = -\rho g (H - z)$,
$\sigma_h = K_0 \sigma_v$ (T26). With $K_0 = \nu/(1 - \nu)$ this is an elastic state of
rest, linear in place, which points that integrate linear functions exactly in every
simplex keep to round-off (doc/theory.md, section 5). A lattice of points does not:
its accelerations at the start are many times gravity, until the stage
`Initial equilibrium` (T35) has brought its stresses into balance.

With $K_0$ = 0.3, outside of the cone, the column settles: without lateral strain the
vertical stress $S$ stays and $p$ rises from $S (1 + 2 K_0)/3$ to
$S / (1 + \tfrac23 m)$, which takes $\tfrac12 H \Delta p/S \, \rho g H / K$ at the top.
The fluidity of 0.05/s makes this slow. The column vibrates about its new state, which
nothing damps, so the mean over the last three periods is compared; flow in the
vibration is not taken back and adds a little.
""")
    symmetric = {2: (1, 3, 4), 3: (1, 4)}
    rows = []
    for dim in (2, 3):
        layouts = [(f"symmetric, {n} per cell",
                    {"Points/body/Points per cell": n}) for n in symmetric[dim]]
        if dim == 2:
            # In a cube of 5 tetrahedra a lattice is exact, too, by symmetry.
            layouts.append(("lattice, 2 x 2 per square",
                            {"Points/body/Layout": "lattice",
                             "Points/body/Spacing": ".05, .05"}))
        for layout in layouts:
            found = acceleration(suite, dim, layout)
            rows.append([f"{dim}D, {layout[0]}", found, ""])
            if layout[0].startswith("symmetric"):
                suite.check(f"{dim}D, {layout[0]}: acceleration / g", found,
                            most=1e-12)
            else:
                suite.check(f"{dim}D, {layout[0]}: acceleration / g (not at "
                            "rest)", found, least=1.)
        for spacing in (.05, .037):
            layout = (f"lattice of {spacing * (dim - 1):g} m",
                      {"Points/body/Layout": "lattice",
                       "Points/body/Spacing": boxes(*[spacing * (dim - 1)] * dim)})
            found = settled_acceleration(suite, dim, layout)
            rows.append([f"{dim}D, {layout[0]}", acceleration(suite, dim, layout),
                         found])
            suite.check(f"{dim}D, {layout[0]}, after Initial equilibrium: "
                        "acceleration / g", found, most=.01)
        run = suite.run(f"column_{dim}d", "rest")
        speed = run.table["max_speed"].max()
        suite.check(f"{dim}D: speed within 0.5 s / free fall",
                    speed / (GRAVITY * .5), most=1e-12)
    suite.table(["points", "largest acceleration at the start / g",
                 "after Initial equilibrium"], rows)
    if suite.quick:
        return
    rows = []
    for dim, cells in ((2, (10, 20, 40)), (3, (8,))):
        for n_cells in cells:
            found = settlement(suite, dim, n_cells)
            rows.append([f"{dim}D, {n_cells}", 1e3 * found,
                         1e3 * expected_settlement()])
        suite.check(f"{dim}D: settlement / formula", found /
                    expected_settlement(), .98, 1.02)
    suite.table(["cells over the height", "settlement of the top [mm]",
                 "formula [mm]"], rows)
