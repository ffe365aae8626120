"""Adaptive meshes of simplices and hypercubes: a block flies through them
unchanged while they are refined and coarsened hundreds of times, a column rests
on several levels, the collapse is that on the fine mesh, and all of it is the
same on any number of processes."""

from _case import (DIMENSIONS, ELASTIC, IS_DEBUG, KINDS, Checks, body, boundaries, box,
                   levels, points_per_cell, rollers, run)

checks = Checks()
SIDES = ["x_min", "x_max", "y_min", "y_max", "z_min", "z_max"]


def flying_block(dim, kind, n_steps):
    """A block flies with a constant velocity through a mesh that is refined
    around a place that moves faster."""
    return f"""
set Dimension = {dim}
set End time  = {n_steps * 1e-3}
{box(dim, [0., 0., 0.], (1.2, .6, .6), (12, 6, 6), kind)}
{body(dim, [.1, .1, .1], (.4, .4, .4), points_per_cell(dim, kind),
      material=ELASTIC.format(density=1000, young=1e3, poisson=.3))}
{boundaries(all=("free", SIDES[:2 * dim]))}
subsection Initial state
  set Velocity = {"; ".join(["0.8", "0.1", "0.1"][:dim])}
end
subsection Body force
  set Gravity = {", ".join(["0"] * dim)}
end
subsection Time step
  set Type       = fixed
  set Fixed step = 1e-3
end
""" + levels("2.4 - 8*sqrt((x - 0.6 - 0.5*sin(300*t))^2 + (y - 0.3)^2)", 2)


def check_same(name, one, other, columns, tolerance):
    for column in columns:
        a, b = one.last(column), other.last(column)
        checks.that(abs(a - b) <= tolerance * abs(a), f"{name}: {column}",
                    f"{a} and {b}")


for dim in DIMENSIONS:
    for kind in KINDS:
        n_steps = 540 if dim == 2 and not IS_DEBUG else 60
        results = {ranks: run(flying_block(dim, kind, n_steps), ranks=ranks)
                   for ranks in ((1, 2, 3) if IS_DEBUG else (1, 3))}
        for ranks, result in results.items():
            name = f"flying block, {dim}D, {kind}, {ranks} processes"
            checks.that(result.exit_code == 0, name, result.text[-2000:])
            if result.exit_code != 0:
                continue
            n_changes = result.manifest["performance"]["adaptations"]
            checks.that(n_changes >= (500 if n_steps == 540 else 50),
                        f"{name}: adaptations", str(n_changes))
            for column in ("points", "mass", "kinetic_energy"):
                values = result[column]
                checks.that(max(values) - min(values) <= 1e-12 * values[0],
                            f"{name}: {column}", f"{values[0]} {values[-1]}")
            checks.that(max(result["elastic_energy"]) <
                        1e-20 * result["kinetic_energy"][0],
                        f"{name}: no stress", str(result.last("elastic_energy")))
            for column, speed in zip(("center_x", "center_y"), (.8, .1)):
                way = result.last(column) - result[column][0]
                checks.that(abs(way - speed * result.last("time")) < 1e-12,
                            f"{name}: {column}", str(way))
            checks.that(result.manifest["counts"]["cells"] ==
                        results[1].manifest["counts"]["cells"],
                        f"{name}: the same mesh", str(result.manifest["counts"]))
        if n_steps == 540 and kind == "simplices":
            # The program's memory does not grow from 60 changes to 540.
            brief = run(flying_block(2, kind, 60))
            short, long = (result.manifest["performance"]["peak_memory_bytes"]
                           for result in (brief, results[1]))
            checks.that(long < 1.1 * short, "memory", f"{short}, {long} bytes")
            # 144 cells, of which none may be divided.
            limited = run(flying_block(2, kind, 60),
                          "Adaptive mesh/Maximum number of cells=144")
            said = "'Maximum number of cells' kept it coarser"
            checks.that(said in limited.text and said not in brief.text and
                        limited.manifest["counts"]["cells"] == 144,
                        "a limited number of cells", limited.text[-500:])


def column(dim, kind, across=""):
    """A geostatic column with symmetric points on three levels, which also
    change `across` it."""
    up = (1., 2.) if dim == 2 else (1., 1., 2.)
    height = "xyz"[dim - 1]
    return f"""
set Dimension = {dim}
set End time  = 0.05
{box(dim, [0., 0., 0.], up, (4, 8) if dim == 2 else (2, 2, 4), kind)}
{body(dim, [0., 0., 0.], up, points_per_cell(dim, kind))}
{rollers(dim)}
subsection Initial state
  set Stress        = geostatic
  set Surface level = 2
  set K0            = 0.4285714285714286
end
""" + levels(f"if({height} < 0.4, 2, if({across or height} < 0.4, 1, 0))",
           2, 1000)


GAUSS = "Points/body/Layout=Gauss"

for dim in DIMENSIONS:
    # In a square, pressure from the side times the gradient of shape functions
    # is quadratic in height, and the centres of four parts do not integrate that
    # exactly: the errors of neighbours cancel if these are of one size.
    skew = run(column(dim, "hypercubes", "x"))
    checks.that(skew.exit_code == 0 and max(skew["kinetic_energy"]) <
                1e-7 * skew["potential_energy"][0], "rest beside larger cells",
                skew.text[-2000:] + str(skew.last("kinetic_energy")))
    for kind, layout, across in (("simplices", [], "x"), ("hypercubes", [], ""),
                                 ("hypercubes", [GAUSS], "x")):
        for scheme in ([], ["Scheme/Mass matrix=near-consistent"],
                       ["Scheme/Stress order=USF"]):
            result = run(column(dim, kind, across), *layout, *scheme)
            name = f"rest, {dim}D, {kind}, {layout}, {scheme}"
            # A wrong force of one part in 1e8 of gravity would be seen.
            limit = 1e-24 if not scheme else 1e-18
            checks.that(result.exit_code == 0 and
                        max(result["kinetic_energy"]) <
                        limit * result["potential_energy"][0], name,
                        result.text[-2000:] + str(result.columns.get(
                            "kinetic_energy", [])[-1:]))


def pushed_block(kind):
    """A block that fills its mesh and is pushed from the top."""
    return f"""
set Dimension = 2
set End time  = 0.05
{box(2, [0., 0.], (1., 2.), (5, 10), kind)}
{body(2, [0., 0.], (1., 2.), 16,
      material=ELASTIC.format(density=1000, young=1e6, poisson=.3))}
{boundaries(free=("free", ["x_min", "x_max", "y_min"]),
            top=("traction", ["y_max"]))}
subsection Boundary conditions
  subsection top
    set Traction = 0; -1000
  end
end
subsection Body force
  set Gravity = 0, 0
end
subsection Time step
  set Type       = fixed
  set Fixed step = 5e-4
end
""" + levels("1.5 - 6*abs(x - 0.4 - 0.3*sin(60*t)) - 3*(2 - y)", 1, 7)


for kind in KINDS:
    for ranks in (1, 3):
        result = run(pushed_block(kind), ranks=ranks)
        name = f"pushed block, {kind}, {ranks} processes"
        checks.that(result.exit_code == 0, name, result.text[-2000:])
        if result.exit_code != 0:
            continue
        # Half a metre per second^2, by symplectic Euler.
        way = 1. - result.last("center_y")
        checks.that(abs(way - .25 * .05 * (.05 + 5e-4)) < 1e-12,
                    f"{name}: way", str(way))
        checks.that(result.manifest["performance"]["adaptations"] > 4,
                    f"{name}: adaptations", str(result.manifest))


def collapse(kind, criterion):
    """A small wall that collapses."""
    return f"""
set Dimension = 2
set End time  = 1
{box(2, [0., 0.], (2.4, 1.2), (24, 12), kind)}
{body(2, [0., 0.], (.5, 1.), 4)}
{boundaries(base=("clamp", ["y_min"]), walls=("roller", ["x_min", "x_max"]),
            open=("free", ["y_max"]))}
subsection Initial state
  set Stress        = geostatic
  set Surface level = 1
  set K0            = 0.4285714285714286
end
subsection Scheme
  set Pressure filter rate = 100
end
subsection Adaptive mesh
  set Names         = sand
  set Maximum level = 1
  {criterion}
end
"""


POINTS = """
  set Buffer layers         = 2
  set Interval displacement = 1.5
  subsection sand
    set Type                     = points
    set Largest number of points = 3
  end
"""
EVERYWHERE = """
  set Minimum level = 1
  subsection sand
    set Type  = region
    set Level = 1
  end
"""
for kind in KINDS:
    # On any number of processes, with every way of summing.
    for settings in ([], ["Scheme/Averaging=nodes"],
                     ["Scheme/Mass matrix=near-consistent"],
                     ["Scheme/Stress order=USF", "Parallel/Partition=METIS"]):
        if kind == "hypercubes" and "Scheme/Averaging=nodes" in settings:
            continue
        # The criterion that leaves points in cells of two levels.
        mixed = POINTS.replace("= points", "= free surface").replace(
            "set Largest number of points = 3", "")
        one, three = (run(collapse(kind, mixed), *settings, "End time=0.1",
                          ranks=ranks) for ranks in (1, 3))
        name = f"collapse, {kind}, {settings}"
        checks.that(one.exit_code == three.exit_code == 0, name,
                    one.text[-2000:] + three.text[-2000:])
        if one.exit_code == three.exit_code == 0:
            check_same(name, one, three, ["points", "mass"], 0.)
            check_same(name, one, three,
                       ["front", "height", "kinetic_energy",
                        "potential_energy"], 1e-9)
    if IS_DEBUG:
        continue
    # The fine mesh only where the sand is makes no difference.
    fine, adaptive = (run(collapse(kind, criterion))
                      for criterion in (EVERYWHERE, POINTS))
    name = f"collapse, {kind}"
    text = (f"front {adaptive.last('front')}, {fine.last('front')}; height "
            f"{adaptive.last('height')}, {fine.last('height')}; cells "
            f"{adaptive.manifest['counts']['cells']}, "
            f"{fine.manifest['counts']['cells']}")
    print(text)
    check_same(name, fine, adaptive, ["front", "height"], .02)
    checks.that(abs(adaptive.last("closure") - fine.last("closure")) < 1e-4,
                f"{name}: closure", f"{adaptive.last('closure')}, "
                f"{fine.last('closure')}")
    checks.that(adaptive.manifest["counts"]["cells"] <
                .5 * fine.manifest["counts"]["cells"], f"{name}: cells", text)
checks.exit()
