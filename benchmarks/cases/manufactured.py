"""A manufactured solution along the axes."""

import math

import numpy
from plotting.convergence import draw_convergence
from studies.orders import observed_orders
from studies.program import read_parameters

from .suite import boxes, matched

TITLE = "d: manufactured solution"

SIGNS = numpy.array([1., -1., 1.])  # of the displacement along x, y, z


# The schemes that are compared, by what is said of them, and their entries.
FLIP = ""
CELLS, NODES = "means of cells", "means of nodes"
LEAST_SQUARES = "least squares"
SCHEMES = {FLIP: {}, CELLS: {"Scheme/Averaging": "cells"},
           NODES: {"Scheme/Averaging": "nodes", "Scheme/Averaged part": "1"},
           f"APIC, {NODES}": {"Scheme/Averaging": "nodes",
                              "Scheme/Averaged part": "1",
                              "Scheme/Velocity update": "APIC"},
           LEAST_SQUARES: {"Scheme/Averaging": "moving least squares"},
           "XPIC(2)": {"Scheme/Velocity update": "XPIC"},
           "FMPM(2)": {"Scheme/Velocity update": "FMPM"}}


def manufactured(suite, dim, n_cells, amplitude, points, scheme=FLIP):
    """The run with the amplitude in place of the input's 0.0001."""
    entries = read_parameters(suite.input_file(f"manufactured_{dim}d"))
    return suite.run(
        f"manufactured_{dim}d",
        f"{n_cells}_cells_amplitude_{amplitude:g}_{points}_points" + (
            f"_{scheme.replace(' ', '_')}" if scheme else ""),
        {entry: entries[entry].replace("0.0001", repr(amplitude))
         for entry in ("Initial state/Velocity", "Body force/Force")} |
        SCHEMES[scheme] |
        {"Mesh/Subdivisions": boxes(*[n_cells] * dim),
         "Points/body/Points per cell": points})


def position(initial, time, amplitude):
    """Where the points are: x - X = A sin(pi x) sin(pi t), by Newton."""
    factor = amplitude * SIGNS * math.sin(math.pi * time)
    x = initial.copy()
    for _ in range(20):
        residual = x - factor * numpy.sin(math.pi * x) - initial
        x -= residual / (1 - factor * math.pi * numpy.cos(math.pi * x))
    return x


def error(run, amplitude):
    """Root of the mean square of the displacement's error over points, times and
    components, relative to the amplitude."""
    squares = []
    for frame, (time, _) in enumerate(run.frames[1:], start=1):
        initial, fields = matched(run, frame)
        exact = position(initial, time, amplitude)
        squares.append(numpy.mean((fields["position"] - exact)
                                  [:, :run.dimension]**2))
    return math.sqrt(numpy.mean(squares)) / amplitude


def add_line(suite, dim, cells, amplitude, points, scheme, rows, lines):
    """Errors over the number of cells: a row, a line and their checks."""
    errors = [error(manufactured(suite, dim, n, amplitude, points, scheme),
                    amplitude) for n in cells]
    sizes = [1 / n for n in cells]
    orders = observed_orders(sizes, errors)
    name = f"{dim}D, {points} point{'s' * (points > 1)}, A = {amplitude:g}" + (
        f", {scheme}" if scheme else "")
    rows.append([name, *[f"{e:.2e} (n = {n})" for n, e in zip(cells, errors)],
                 *[""] * (4 - len(cells)),
                 ", ".join(f"{order:.2f}" for order in orders)])
    lines[name] = (sizes, errors)
    if amplitude == 1e-4 and points == 4:
        for n, order in zip(cells[1:], orders):
            if n <= 32:  # beyond, single precision is felt
                suite.check(f"{name}: order at n = {n}", order, 1.8, 2.3)
    if NODES in scheme or scheme == LEAST_SQUARES or (scheme == CELLS and
                                                      dim == 2):
        suite.check(f"{name}: mean order",
                    math.log(errors[0] / errors[-1]) /
                    math.log(sizes[0] / sizes[-1]), 1.5)


def verify(suite):
    suite.text(r"""
In a unit box between smooth walls (density, E: 1; Poisson ratio 0.3) the point now at
$x$ came from $X$ with

$$ X_i = x_i - A_i \sin(\pi x_i) S, \quad S = \sin(\pi t), \quad
g_i = 1 - A_i \pi \cos(\pi x_i) S = 1/F_i, \quad A = (A, -A, A) $$

so velocity, volume ratio and stress are known at every place,

$$ v_i = A_i \pi C \sin(\pi x_i) / g_i, \quad C = \cos(\pi t), \quad
J = \prod_j 1/g_j, \quad \sigma_i = \lambda \ln J + 2 G \ln F_i $$

and the body force (`Body force/Force`) is what the balance of momentum T1 needs,

$$ b_i = \frac{\partial v_i}{\partial t} + v_i \frac{\partial v_i}{\partial x_i} +
\frac{\lambda + 2 G}{\rho_0} J A_i \pi^2 \sin(\pi x_i) S / g_i $$

After Wallstedt & Guilkey, *J. Comput. Phys.* 227 (2008) 9628, with the law of this
program and the inverse map given, so that the force is explicit in place and time.
The error is the root of the mean square of the points' displacement error over ten
times in half a period, relative to A.

With A = 0.0001 no point leaves its cell and the order is the second, until the
single precision of the files of points (about 2e-4 A) and a part of some 1.4 A are
felt: a cell that no point leaves keeps its size while the volumes of its points follow
the strain. With A = 0.01 and more, points cross cells, and the error stops falling or
grows with refinement: this is the method on linear simplices (Steffen, Kirby & Berzins
2008), not a tolerance. Means over cells, and around nodes with `Averaged part = 1`
(T40 to T43), bring the second order back in the plane; in space those around nodes do
best. The price is a larger error on coarse meshes and where no point crosses. XPIC and
FMPM (T66, T67) filter velocities but leave the forces as they are, and with them the
order. APIC (T68) with means around nodes has smaller errors than FLIP with these means.
Moving least squares (T90 to T92) have the second order as well, and in space the
smallest errors from n = 8 on.
""")
    rows, lines = [], {}
    for dim, points in ((2, 4), (2, 1), (3, 4), (3, 1)):
        cells = (8, 16, 32, 64) if dim == 2 else (4, 8, 16)
        if suite.quick:
            cells = cells[:-1]
        for amplitude in (1e-4, .01, .05):
            if (points == 1 or suite.quick) and amplitude != 1e-4:
                continue
            if points == 1 and suite.quick:
                continue
            for scheme in SCHEMES if amplitude == .05 else (FLIP,):
                if points == 4 or scheme in (FLIP, CELLS, NODES):
                    add_line(suite, dim, cells, amplitude, points, scheme, rows,
                             lines)
    suite.table(["", "error", "", "", "", "orders"], rows)

    def draw(left, right):
        for axes, dim in ((left, "2D"), (right, "3D")):
            draw_convergence(axes, {name: line for name, line in lines.items()
                                    if name.startswith(dim)}, (1, 2),
                             error_label=f"error of displacement / A, {dim}")
    suite.figure("manufactured", "Error over the size of cells", draw, 2)
