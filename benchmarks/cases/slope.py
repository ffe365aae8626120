"""Flow of an infinite layer down a slope."""

import math

import numpy
from plotting.convergence import line_style

from .suite import boxes, matched

TITLE = "f: layer on a slope"

GRAVITY, DENSITY, FLUIDITY = 9.81, 1500., .02
SLOPE = 18 * .5 / (9 - .25)  # of the cone


def steady_rate(angle, exponent):
    """Shear rate of the steady flow, the same at every depth [1/s]."""
    excess = math.sqrt(3) * math.tan(math.radians(angle)) / SLOPE - 1
    return math.sqrt(3) * FLUIDITY * excess**exponent


def bessel(order, x):
    """J_0 or J_1 by Bessel's integral (trapezoidal rule, spectrally exact)."""
    angle = (numpy.arange(400) + .5) * math.pi / 400
    return numpy.mean(numpy.cos(order * angle - numpy.multiply.outer(
        numpy.asarray(x), numpy.sin(angle))), axis=-1)


def bessel_zeros(count):
    """The first zeros of J_0, by Newton from McMahon's estimate."""
    x = (numpy.arange(1, count + 1) - .25) * math.pi
    for _ in range(20):
        x += bessel(0, x) / bessel(1, x)
    return x


def displacement(height, time, angle):
    """Displacement at heights above the base of a layer of 1 m that starts at rest
    on the cone, N = 1: the time integral of the velocity that the balance of
    momentum gives, with a viscosity m p/(3 gamma) that grows linearly with depth."""
    theta = math.radians(angle)
    diffusion = SLOPE * GRAVITY * math.cos(theta) / (3 * FLUIDITY)
    drive = GRAVITY * (math.sin(theta) -
                       SLOPE * math.cos(theta) / math.sqrt(3))
    zeros = bessel_zeros(60)
    rates = diffusion * zeros**2 / 4
    terms = (8 * bessel(0, numpy.multiply.outer(numpy.sqrt(1 - height), zeros)) /
             (zeros**3 * bessel(1, zeros)) *
             (1 - numpy.exp(-rates * time)) / rates)
    return drive / diffusion * (height * time - terms.sum(axis=-1))


def layer(suite, dim, n_cells, angle, exponent, end):
    """The run with n_cells over the depth of 1 m; tractions, gravity and initial
    stress follow from the angle."""
    theta = math.radians(angle)
    along = GRAVITY * math.sin(theta)
    across = GRAVITY * math.cos(theta)
    size = 1. / n_cells
    flat = [0.] * (dim - 2)
    depth = "max(1 - y, 0)"
    pressure = f"{DENSITY * across!r}*{depth}"
    shear = f"{DENSITY * across * SLOPE / math.sqrt(3)!r}*{depth}"
    zeros = "; 0" * (dim - 1)
    stress = [f"-{pressure}"] * 3 + [shear] + ["0"] * (2 if dim == 3 else 0)
    return suite.run(
        f"slope_{dim}d", f"{n_cells}_cells_{angle:g}_exponent_{exponent:g}", {
            "End time": end,
            "Mesh/Upper corner": boxes(2 * size, 1 + size,
                                       *[size] * (dim - 2)),
            "Mesh/Subdivisions": boxes(2, n_cells + 1, *[1] * (dim - 2)),
            "Points/body/Upper corner": boxes(2 * size, 1., *[size] * (dim - 2)),
            "Materials/sand/Perzyna exponent": exponent,
            "Body force/Gravity": boxes(along, -across, *flat),
            "Initial state/Stress components": "; ".join(stress),
            "Boundary conditions/upstream/Traction": pressure + zeros,
            "Boundary conditions/downstream/Traction": f"-{pressure}{zeros}"})


def profile(run, frame):
    """Heights at the start and displacements along the slope of the points. A
    point moves with the velocity of the grid, so this is free of the part of the
    points' own velocities that the grid does not see."""
    initial, fields = matched(run, frame)
    return initial[:, 1], fields["position"][:, 0] - initial[:, 0]


def since(run, time):
    """Heights, and displacements between a time and the end."""
    height, moved = profile(run, len(run.frames) - 1)
    return height, moved - profile(run, run.frame_at(time))[1]


def verify(suite):
    suite.text(r"""
In a layer of depth $H$ on a rough slope of the angle $\theta$, all normal stresses are
$-p$ with $p = \rho g \xi \cos\theta$ at the depth $\xi$, and
$\tau = p \tan\theta$, as flow and stress deviator are coaxial. So T6 gives a shear
rate that is the same everywhere, for every exponent,

$$ \dot\gamma = \sqrt3 \gamma \left( \sqrt3 \tan\theta / m - 1 \right)^N $$

With $N = 1$, started at rest on the cone ($\tau = m p/\sqrt3$), $D = m g \cos\theta
/ 3\gamma$, $U = g (\sin\theta - m \cos\theta / \sqrt3)$, and $j_k$ the zeros of
$J_0$,

$$ u = \frac{U}{D} \left[ H - \xi - H \sum_k \frac{8 J_0(j_k \sqrt{\xi/H})}
{j_k^3 J_1(j_k)} e^{-D j_k^2 t / 4H} \right] $$

by separation of variables (Watson, *Theory of Bessel Functions*, 1944, ch. 18).
Compared is its integral over time, the displacement of the points; they move with the
velocity of the grid.
A strip of the layer is computed, two cells wide, whose ends bear the pressure $p$ and
move along only; the fluidity of 0.02/s makes the steady state arrive before points
have moved far. The ends stay where they are while the layer moves on, and its pressure
falls short by a part of about the shear strain so far: with the fluidity, and so the
strain, larger the rate deviates in proportion (1.3 % at 0.05/s, 32 degrees). E = 1 GPa:
finite shear makes normal stresses of $\tau^2/G$ that change the flow by
$2 \cdot 10^{-4}$; elastic shear is small beside the flow after the first third of the
time, from which on displacements are compared. The steady profile is linear, so the
mesh matters little and no order is asked for.
""")
    cells = (5, 10) if suite.quick else (5, 10, 20, 40)
    end = .06
    rows = []
    for dim in (2,) if suite.quick else (2, 3):
        use = cells if dim == 2 else cells[:3]
        errors = []
        for n in use:
            run = layer(suite, dim, n, 32., 1., end)
            height, moved = since(run, end / 3)
            exact = (displacement(height, end, 32.) -
                     displacement(height, end / 3, 32.))
            errors.append(math.sqrt(numpy.mean((moved - exact)**2)) /
                          exact.max())
        rows.append([f"{dim}D", *errors, *[""] * (len(cells) - len(use))])
        suite.check(f"{dim}D: finest error of displacement", errors[-1], most=2e-3)
    suite.table(["32 degrees, N = 1: error of displacement / that of the surface"] +
                [f"{n} cells" for n in cells], rows)
    if suite.quick:
        return

    rows, rates = [], []
    for angle, exponent, duration in (
            (31., 1., .06), (32., 1., .06), (33., 1., .06), (35., 1., .06),
            (33., 2., .06), (33., .5, .12)):
        run = layer(suite, 2, 20, angle, exponent, duration)
        height, moved = since(run, duration - .02)
        rate = numpy.polyfit(height, moved, 1)[0] / .02 / FLUIDITY
        exact = steady_rate(angle, exponent) / FLUIDITY
        rates.append((angle, exponent, rate))
        rows.append([f"{angle:g}", f"{exponent:g}", rate, exact,
                     f"{100 * (rate / exact - 1):.2f} %"])
        suite.check(f"steady rate at {angle:g} degrees, N = {exponent:g}: "
                    "ratio to the formula", rate / exact, .99, 1.01)
    suite.table(["slope [degrees]", "N", "shear rate / fluidity", "formula",
                 "deviation"], rows, digits=4)

    def draw(left, right):
        angles = numpy.linspace(30.8, 35.4, 80)
        for index, exponent in enumerate((.5, 1., 2.)):
            style = line_style(index)
            left.plot(angles, [steady_rate(angle, exponent) / FLUIDITY
                               for angle in angles], color=style["color"],
                      linewidth=1., label=f"N = {exponent:g}")
            measured = [(angle, rate) for angle, n, rate in rates
                        if n == exponent]
            left.plot(*zip(*measured), linestyle="", marker=style["marker"],
                      color=style["color"])
        left.set_xlabel("slope [degrees]")
        left.set_ylabel("shear rate / fluidity")
        left.legend(fontsize=9)
        run = layer(suite, 2, 20, 32., 1., .06)
        fine = numpy.linspace(0., 1., 101)
        for index, frame in enumerate((1, 2, 3, 6)):
            time = run.frames[frame][0]
            height, moved = profile(run, frame)
            colour = line_style(index)["color"]
            right.plot(1e3 * displacement(fine, time, 32.), fine, color=colour,
                       linewidth=1., label=f"{time:g} s")
            right.plot(1e3 * moved[::4], height[::4], ".", markersize=4,
                       color=colour)
        right.set_xlabel("displacement along the slope [mm]")
        right.set_ylabel("height above the base [m]")
        right.legend(fontsize=9)
    suite.figure("slope", "Steady shear rate and displacement over time: runs "
                 "(points) and formulas (lines)", draw, 2)
