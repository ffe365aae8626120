"""Elastic bodies that hit each other and part again."""

import math

import numpy
from plotting.convergence import line_style

from .suite import boxes, matched

TITLE = "i: impact"

YOUNG, POISSON, RADIUS = 1e6, .3, .2  # of the balls
DENSITY, SPEED = 1500., 1.            # speed at which they meet


def hertz():
    """Approach, duration and largest force of two equal balls."""
    mass = DENSITY * 4 / 3 * math.pi * RADIUS**3 / 2
    modulus = YOUNG / (2 * (1 - POISSON**2))
    radius = RADIUS / 2
    approach = (15 * mass * SPEED**2 /
                (16 * math.sqrt(radius) * modulus))**.4
    return (approach, 2.9432 * approach / SPEED,
            4 / 3 * modulus * math.sqrt(radius) * approach**1.5)


def hertz_force(n_steps=4000):
    """Force over its largest value during the contact, times over duration."""
    approach, duration, force = hertz()
    mass = DENSITY * 4 / 3 * math.pi * RADIUS**3 / 2
    x, v, dt, forces = 0., SPEED, duration / n_steps, []
    for _ in range(n_steps):
        ratio = max(x / approach, 0.)**1.5
        forces.append(ratio)
        v -= dt * force / mass * ratio
        x += dt * v
    return numpy.arange(n_steps) / n_steps, numpy.array(forces)


def width(times, force):
    """How long the force is above half of its largest value."""
    above = times[force > .5 * force.max()]
    return above[-1] - above[0]


def disks(suite, n_cells):
    run = suite.run("disks_2d", f"{n_cells}_cells",
                    {"Mesh/Subdivisions": boxes(n_cells, n_cells)})
    momentum, lower = [], None
    for frame in range(len(run.frames)):
        initial, fields = matched(run, frame)
        lower = initial[:, 0] + initial[:, 1] < 1
        along = (fields["velocity"][:, 0] + fields["velocity"][:, 1]) / 2
        momentum.append([(fields["mass"][part] * along[part]).sum()
                         for part in (lower, ~lower)])
    return run, numpy.array([time for time, _ in run.frames]), numpy.array(
        momentum)


def ball(suite, n_cells):
    """Force on the ball over time, from its centre of mass, smoothed over 4 ms."""
    run = suite.run("sphere_3d", f"{n_cells}_cells",
                    {"Mesh/Subdivisions": boxes(n_cells, n_cells, 2 * n_cells)})
    table = run.table
    time = numpy.arange(0., table["time"][-1], 2e-4)
    center = numpy.interp(time, table["time"], table["center_z"])
    mass = 4 * table["mass"][0]
    window = 20
    velocity = (center[window:] - center[:-window]) / (window * 2e-4)
    force = mass * (velocity[window:] - velocity[:-window]) / (window * 2e-4)
    return run, time[window:-window], force


def verify(suite):
    suite.text(r"""
Two elastic disks (radius 0.2 m, E = 1000 Pa, Poisson ratio 0.3, 1000 kg/m³) move
towards each other with (0.1, 0.1) m/s: the case of Sulsky, Chen & Schreyer, *Comput.
Methods Appl. Mech. Eng.* 118 (1994) 179. Kinetic energy
$\rho \pi R^2 v^2$ = 2.513 J/m; the disks touch at 1.586 s. The grid lets bodies feel
each other as soon as they share a node, up to a cell earlier. After they have parted,
kinetic and elastic energy together must be what they were. The kinetic energy alone is
less, and oscillates: the disks meet at a quarter of the wave speed and go on vibrating.
With finer cells, which points cross more often, somewhat more stays in stresses.
""")
    rows = []
    for n_cells in (20,) if suite.quick else (20, 40, 80):
        run, times, momentum = disks(suite, n_cells)
        table = run.table
        start = momentum[0, 0]
        moved = 1 - momentum[:, 0] / start
        contact = numpy.interp(.02, moved[:numpy.argmax(moved > .02) + 1],
                               times[:numpy.argmax(moved > .02) + 1])
        kinetic = table["kinetic_energy"]
        energy = kinetic + table["elastic_energy"]
        total = numpy.abs(momentum.sum(axis=1)).max() / start
        rebound = -momentum[-1, 0] / start
        rows.append([n_cells, kinetic[0], contact, kinetic.min() / kinetic[0],
                     kinetic[-1] / kinetic[0], energy[-1] / energy[0], rebound,
                     total])
        suite.check(f"disks, {n_cells} cells: sum of momenta / momentum of "
                    "one", total, most=1e-5)
        suite.check(f"disks, {n_cells} cells: kinetic energy at the start [J/m]",
                    kinetic[0], .95 * 2.51327, 1.05 * 2.51327)
        suite.check(f"disks, {n_cells} cells: first contact [s]", contact,
                    1.5858 - math.sqrt(2) / n_cells / .2828 - .1, 1.5858 + .1)
        # Exact is 1; the formula of elastic energy is good to p/K, some 0.02.
        suite.check(f"disks, {n_cells} cells: kinetic + elastic energy kept",
                    energy[-1] / energy[0], .98, 1.02)
    suite.table(["cells per metre", "KE at the start [J/m]", "2 % of momentum "
                 "exchanged at [s]", "least KE", "KE at the end",
                 "KE + elastic energy", "momentum after / before",
                 "sum of momenta"], rows)
    if suite.quick:
        return

    approach, duration, force = hertz()
    shape = hertz_force()
    suite.text(rf"""
A ball (radius 0.2 m, E = 1 MPa, Poisson ratio 0.3, 1500 kg/m³; a quarter of it is
computed) hits a smooth wall with 0.5 m/s, the same by symmetry as two equal balls that
meet with $v$ = 1 m/s. Hertz's theory (Landau & Lifshitz, *Theory of Elasticity*,
§9; Johnson, *Contact Mechanics*, ch. 11): approach
$\delta = (15 m_* v^2 / 16 \sqrt{{R_*}} E_*)^{{2/5}}$ = {1e3 * approach:.1f} mm, duration
$2.943 \delta / v$ = {duration:.4f} s, force
$\tfrac43 E_* \sqrt{{R_*}} \delta^{{3/2}}$ = {force:.0f} N. The theory is one of small
contacts; here $\delta / R$ is {approach / RADIUS:.2f}, and the contact's radius some
cells. Because contact begins up to a cell early, durations are compared where the
force is above half of its largest value ({width(*shape) * duration:.4f} s).
""")
    rows, curves = [], {}
    for n_cells in (8, 12, 18):
        run, times, found = ball(suite, n_cells)
        kinetic = run.table["kinetic_energy"]
        lasts = width(times, found)
        rows.append([.24 / n_cells, run.table["points"][0], found.max(),
                     found.max() / force, lasts,
                     lasts / (width(*shape) * duration),
                     kinetic[-1] / kinetic[0]])
        curves[f"h = {.24 / n_cells:.3g} m"] = (times, found)
    suite.check("ball, finest: largest force / Hertz", found.max() / force,
                .85, 1.15)
    suite.check("ball, finest: duration above half force / Hertz", rows[-1][5],
                .85, 1.15)
    suite.check("ball, finest: kinetic energy kept", rows[-1][6], .85, 1.)
    suite.table(["cells [m]", "points", "largest force [N]", "over Hertz",
                 "above half for [s]", "over Hertz", "KE kept"], rows)

    def draw(left, right):
        for index, n_cells in enumerate((20, 40, 80)):
            table = disks(suite, n_cells)[0].table
            left.plot(table["time"],
                      table["kinetic_energy"] / table["kinetic_energy"][0],
                      color=line_style(index)["color"],
                      label=f"{n_cells} cells per metre")
        left.axvline(1.5858, color="0.5", linestyle="--", linewidth=1.)
        left.annotate("disks touch", (1.5858, .02), rotation=90, color="0.4",
                      fontsize=9, ha="right", xycoords=("data",
                                                        "axes fraction"))
        left.set_xlabel("time [s]")
        left.set_ylabel("kinetic energy / initial, disks")
        left.legend(fontsize=9)
        for index, (label, (times, found)) in enumerate(curves.items()):
            peak = times[numpy.argmax(found)]
            right.plot(1e3 * (times - peak), found, label=label,
                       color=line_style(index)["color"])
        times, found = shape
        right.plot(1e3 * (times - .5) * duration, found * force, "k--",
                   linewidth=1., label="Hertz")
        right.set_xlabel("time from the largest force [ms]")
        right.set_xlim(-70., 70.)
        right.set_ylabel("force on the ball [N]")
        right.legend(fontsize=9)
    suite.figure("impact", "Disks: kinetic energy; ball: force", draw, 2)
