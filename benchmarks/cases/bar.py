"""An elastic bar in its first axial mode."""

import math

import numpy
from plotting.convergence import draw_convergence, line_style
from studies.orders import observed_orders

from .suite import boxes

TITLE = "c: vibration of a bar"

LENGTH, OMEGA = 25., math.pi / 50 * 10
SMOOTH = "moving least squares"
LABELS = {"none": "", "cells": ", means of cells", "nodes": ", means of nodes",
          SMOOTH: f", {SMOOTH}"}


def bar(suite, dim, n_cells, speed, averaging="none"):
    """The run with n_cells along the bar, square in section."""
    size = LENGTH / n_cells
    across = [size] * (dim - 1)
    zeros = "; 0" * (dim - 1)
    name = f"{n_cells}_cells_speed_{speed:g}" + (
        f"_averaged_{averaging.replace(' ', '_')}" if averaging != "none" else "")
    return suite.run(f"bar_{dim}d", name, {
        "Scheme/Averaging": averaging,
        "Mesh/Upper corner": boxes(30., *across),
        "Mesh/Subdivisions": boxes(n_cells * 6 // 5, *[1] * (dim - 1)),
        "Points/body/Upper corner": boxes(LENGTH, *across),
        "Initial state/Velocity": f"{speed!r}*sin(pi*x/50){zeros}"})


def errors(run, speed):
    """Roots of the mean squares over time of two errors relative to the
    amplitudes, of the centre's displacement and of the mean speed; and the energy
    at the end over that at the start.

    Velocities are half a step old and compared with the formula then.
    """
    table = run.table
    time, dt = table["time"][1:], table["dt"][1:]
    amplitude = 2 * speed / (math.pi * OMEGA)
    found = table["center_x"] - table["center_x"][0]
    displacement = found[1:] / amplitude - numpy.sin(OMEGA * time)
    # The mean square of the mode's velocity is (V0 cos)^2/2.
    velocity = (numpy.sqrt(table["kinetic_energy"][1:] / table["mass"][1:]) *
                2 / speed - numpy.abs(numpy.cos(OMEGA * (time - dt / 2))))
    energy = table["kinetic_energy"] + table["elastic_energy"]
    return (numpy.sqrt(numpy.mean(displacement**2)),
            numpy.sqrt(numpy.mean(velocity**2)), energy[-1] / energy[0])


def verify(suite):
    suite.text(r"""
The bar (25 m, E = 100 Pa, density 1 kg/m³, Poisson ratio 0, smooth walls around it)
is fixed at one end; $v = V_0 \sin(\beta x) \cos(\omega t)$ with
$\beta = \pi / 2L$, $\omega = \beta \sqrt{E/\rho}$, over one period. The centre of
mass moves by $2 V_0 \sin(\omega t) / (\pi \omega)$. Source: Bardenhagen, *J.
Comput. Phys.* 180 (2002) 383; Buzzi, Pedroso & Giacomini, *CMES* 31 (2008) 85.

With $V_0$ = 1 mm/s points stay in their cells and the error of displacement falls
with the second order. The kinetic energy is that of velocities half a time step
old, and is compared there. With $V_0$ = 0.1 m/s points cross cells from some
refinement on, which linear shape functions do not survive without error (Steffen,
Kirby & Berzins, *Int. J. Numer. Meth. Eng.* 76 (2008) 922): no convergence is
expected, and none is seen. With means over cells or around nodes
(`Scheme/Averaging`, T40 to T43) the error does not grow in the plane: the formula is
that of small strains, at 0.1 m/s the strain reaches 0.01, and some 0.003 remain. In
space it is smaller around nodes than without, but grows with the finest mesh; means
over cells even feed energy into the bar there. With moving least squares (T90 to T92)
it grows in neither.
""")
    rows, lines = [], {}
    for dim in (2, 3):
        cells = ((10, 20, 40) if suite.quick else
                 (10, 20, 40, 80, 160) if dim == 2 else (10, 20, 40, 80))
        for speed, averaging in ((1e-3, "none"), (.1, "none"), (.1, "cells"),
                                 (.1, "nodes"), (.1, SMOOTH)):
            if suite.quick and speed == .1:
                continue
            found = [errors(bar(suite, dim, n, speed, averaging), speed)
                     for n in cells]
            sizes = [LENGTH / n for n in cells]
            displacement = [f[0] for f in found]
            orders = [math.nan] + observed_orders(sizes, displacement)
            rows += [[f"{dim}D", f"{speed:g}", averaging, n, *f[:2], order,
                      f"{f[2]:.5f}"] for n, f, order in
                     zip(cells, found, orders)]
            name = f"{dim}D, {speed:g} m/s" + LABELS[averaging]
            lines[name] = (sizes, displacement)
            if averaging == SMOOTH or averaging != "none" and dim == 2:
                suite.check(f"{name}: the finest error over the one before",
                            displacement[-1] / displacement[-2], most=1.1)
            if speed == 1e-3:
                for n, order in zip(cells[1:], orders[1:]):
                    suite.check(f"{dim}D, 1 mm/s: order of displacement at "
                                f"n = {n}", order, 1.8, 2.2)
                suite.check(f"{dim}D, 1 mm/s: finest error of displacement",
                            displacement[-1], most=1e-3 if not suite.quick
                            else 2e-3)
                suite.check(f"{dim}D, 1 mm/s: energy kept", found[-1][2],
                            .999, 1.0001)
    suite.table(["", "V0 [m/s]", "averaging", "cells", "error of displacement",
                 "error of mean speed", "order of displacement",
                 "energy kept"], rows)

    def draw(left, right):
        draw_convergence(left, lines, (1, 2),
                         error_label="error of displacement / amplitude")
        for index, n in enumerate((20, 160)):
            table = bar(suite, 2, n, .1).table
            amplitude = .2 / (math.pi * OMEGA)
            right.plot(table["time"],
                       (table["center_x"] - table["center_x"][0]) / amplitude,
                       label=f"{n} cells", color=line_style(index)["color"])
        right.plot(table["time"], numpy.sin(OMEGA * table["time"]), "k--",
                   linewidth=1., label="exact")
        right.set_xlabel("time [s]")
        right.set_ylabel("displacement / amplitude, 0.1 m/s, 2D")
        right.legend()
    suite.figure("bar", "Error over the size of cells; displacement over time",
                 draw, 2)
