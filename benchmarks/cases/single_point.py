"""Stress of one point against closed forms, in cells whose nodes all have a given
velocity."""

import math

import numpy
from plotting.convergence import draw_convergence
from studies.orders import observed_orders
from studies.tables import number

TITLE = "a, b: stress at a point"

BULK = 1e6 / (3 * (1 - 2 * .3))
SHEAR = 1e6 / (2 * (1 + .3))
SLOPE = 18 * .5 / (9 - .25)  # of the cone, 30 degrees
FLUIDITY = 50.


def stress_range(run):
    """Stress at the end, mean over the points: xx, yy, zz, xy; and the largest
    deviation of a point from it, relative to the largest component."""
    points = run.points(len(run.frames) - 1)
    stress = numpy.column_stack([points[f"stress_{component}"].astype(float)
                                 for component in ("xx", "yy", "zz", "xy")])
    mean = stress.mean(axis=0)
    return mean, numpy.abs(stress - mean).max() / numpy.abs(mean).max()


def equivalent(stress):
    """p and q of a stress xx, yy, zz, xy."""
    pressure = -stress[:3].mean()
    deviator = stress[:3] + pressure
    return pressure, math.sqrt(1.5 * (deviator @ deviator + 2 * stress[3]**2))


def steady_shear(rate, exponent, pressure):
    """Shear and normal stress in steady shear: Jaumann's rate turns the stress,
    s12 = G r l/(l^2 + r^2), s11 = G r^2/(l^2 + r^2), l = 3 G gamma Phi/q."""
    def overstress(relaxation):
        q = math.sqrt(3) * SHEAR * rate / math.hypot(relaxation, rate)
        phi = max(q / (SLOPE * pressure) - 1, 0)**exponent
        return 3 * SHEAR * FLUIDITY * phi / q - relaxation
    low, high = 1e-6, 1e9  # falls with the relaxation rate
    for _ in range(200):
        middle = math.sqrt(low * high)
        low, high = ((middle, high) if overstress(middle) > 0
                     else (low, middle))
    return (SHEAR * rate * low / (low**2 + rate**2),
            SHEAR * rate**2 / (low**2 + rate**2))


def oedometer(time):
    """q after a time of compression at the rate 1/s, E = 1 MPa, nu = 0.2,
    gamma = 1/s, from p = 1 kPa on the cone."""
    bulk, shear = 1e6 / 1.8, 1e6 / 2.4
    pressure = 1000 + bulk * time
    rate = 3 * shear + SLOPE * bulk
    steady = (2 * shear - SLOPE * bulk) / rate
    excess = steady - steady * (pressure / 1000)**(-rate / (SLOPE * bulk))
    return (1 + excess) * SLOPE * pressure


def final_stresses(suite, dim, case, steps, end, settings=None):
    """The stress at the end for numbers of steps; all points must agree."""
    runs = [suite.run(f"{case}_{dim}d", "_".join(
        [f"{count}_steps", *map(str, (settings or {}).values())]),
        {"Time step/Fixed step": end / count} | (settings or {}))
        for count in steps]
    stresses, spreads = zip(*[stress_range(run) for run in runs])
    # Files hold numbers in single precision.
    name = ", ".join([case, f"{dim}D", *(f"{entry.split('/')[-1]} {value}"
                                         for entry, value in
                                         (settings or {}).items())])
    suite.check(f"{name}: points differ by", max(spreads), most=2e-6)
    return stresses


def verify(suite):
    suite.text(r"""
The nodes of one layer of cells all have a given velocity, so every point has the
same strain. Sources: Dienes, *Acta Mech.* 32 (1979) 217 (shear with Jaumann's
rate); Perzyna, *Adv. Appl. Mech.* 9 (1966) 243 (relaxation, steady flow); the
others by integration of T3 to T7. Drained triaxial compression needs a given
lateral stress on a mesh that moves and is covered by the unit test
materials/triaxial.

| case | formula |
|---|---|
| simple shear to $k = 1$ | $s_{xy} = G \sin k$, $s_{xx} = -s_{yy} = G (1 - \cos k)$ |
| steady viscoplastic shear, 10/s at 10 kPa | $s_{xy} = G r \lambda / (\lambda^2 + r^2)$, $s_{xx} = -s_{yy} = G r^2 / (\lambda^2 + r^2)$, $\lambda = 3 G \gamma \Phi / q$ |
| relaxation from $q = 2 m p$ over $2 \tau$ | $q = m p (1 + e^{-t/\tau})$, $\tau = m p / (3 G \gamma)$ |
| oedometer at the rate $a$ | $x = q/(mp) - 1 = x_* + (x_0 - x_*) (p/p_0)^{-r}$, $x_* = (2G - mK) a / (3 G \gamma + m K a)$, $r = (3 G \gamma + m K a)/(m K a)$ |
""")
    steps = (20, 40, 80) if suite.quick else (10, 20, 40, 80, 160)
    shear = 100.

    def elastic_error(stress):
        exact = shear * numpy.array([1 - math.cos(1), math.cos(1) - 1, 0,
                                     math.sin(1)])
        return numpy.abs(stress - exact).max() / shear

    def relaxed(stress):
        exact = SLOPE * 1e4 * (1 + math.exp(-2))
        return abs(equivalent(stress)[1] / exact - 1)

    def compressed(stress):
        return abs(equivalent(stress)[1] / oedometer(.02) - 1)

    cases = [("simple_shear", "simple shear", 1., elastic_error, 2),
             ("relaxation", "relaxation", 3.565714e-4, relaxed, 1),
             ("oedometer", "oedometer", .02, compressed, 1)]
    lines, rows = {}, []
    for case, name, end, exact, order in cases:
        for dim in (2, 3):
            errors = [exact(stress) for stress in
                      final_stresses(suite, dim, case, steps, end)]
            orders = observed_orders([1 / n for n in steps], errors)
            rows.append([f"{name}, {dim}D", *errors, orders[-1]])
            suite.check(f"{name}, {dim}D: order", orders[-1],
                        order - .1, order + .1)
        lines[name] = ([1 / n for n in steps], errors)
    suite.table(["relative error"] + [f"{n} steps" for n in steps] +
                ["last order"], rows)

    steps, rows = (1000, 2000, 4000), []
    for dim in (2,) if suite.quick else (2, 3):
        for exponent in (1, 2):
            xy, xx = steady_shear(10., exponent, 1e4)
            found = final_stresses(suite, dim, "viscoplastic_shear", steps, .1,
                                   {"Materials/sand/Perzyna exponent": exponent})
            errors = [abs((stress[0] - stress[:3].mean()) / xx - 1)
                      for stress in found]
            rows.append([f"N = {exponent}, {dim}D", found[-1][3], xy, xx,
                         *[number(error) for error in errors]])
            suite.check(f"steady shear, N = {exponent}, {dim}D: error of shear "
                        "stress", abs(found[-1][3] / xy - 1), most=1e-4)
            suite.check(f"steady shear, N = {exponent}, {dim}D: order of normal "
                        "stress", observed_orders([1 / n for n in steps],
                                                  errors)[-1], .9, 1.1)
    suite.table(["steady shear", "s_xy [Pa]", "formula", "s_xx, formula"] +
                [f"error of s_xx, {n} steps" for n in steps], rows, digits=6)
    suite.figure("single_point", "Errors over the time step", lambda axes:
                 draw_convergence(axes, lines, (1, 2),
                                  size_label="time step / duration"))
