"""Runs on 1, 2, 3 and 7 processes: the same numbers up to round-off after 100
steps, the same deposit; the load stays even; an error on one process ends all of
them with one message and the exit code."""

from _case import (ELASTIC, INPUTS, IS_DEBUG, KINDS, SQUARES, Checks, body, boundaries,
                   box, escaping_body, run)

checks = Checks()


def check_same(name, one, other, columns, tolerance):
    if not one.columns or not other.columns:
        checks.that(False, name, one.text[-2000:] + other.text[-2000:])
        return
    for column in columns:
        a, b = one.last(column), other.last(column)
        checks.that(abs(a - b) <= tolerance * abs(a), f"{name}: {column}",
                    f"{a} and {b}")


# A hundred steps of the shipped walls, in space and plane, with every partition
# and with the schemes that sum over nodes in other ways.
COARSE = "Mesh/File=" + str(INPUTS / "meshes" / "wall_coarse.msh")
METIS = "Parallel/Partition=METIS"
CUBES = ["Mesh/Subdivisions=40, 2, 22", "Output/Write grid=true"]
CASES = [
    ("space, hexahedra", "wall_hexahedra.prm", [*CUBES, "End time=0.1"]),
    ("space", "wall.prm", [COARSE, "End time=0.05"]),
    ("plane, METIS", "wall_2d.prm", ["End time=0.04", METIS]),
    ("plane, moving least squares", "wall_2d.prm",
     ["End time=0.02", "Scheme/Averaging=moving least squares"]),
    ("plane, near-consistent", "wall_2d.prm",
     ["End time=0.02", "Scheme/Mass matrix=near-consistent"]),
    ("space, hexahedra, near-consistent, USF", "wall_hexahedra.prm",
     [*CUBES, "End time=0.05", "Scheme/Mass matrix=near-consistent",
      "Scheme/Stress order=USF"]),
    ("plane, averages around nodes", "wall_2d.prm",
     ["End time=0.04", "Scheme/Averaging=nodes"]),
    ("plane, APIC", "wall_2d.prm",
     ["End time=0.02", "Scheme/Velocity update=APIC",
      "Scheme/Averaging=nodes", "Scheme/Position shift rate=10"]),
    ("plane, XPIC(3), USF", "wall_2d.prm",
     ["End time=0.02", "Scheme/Velocity update=XPIC", "Scheme/Order=3",
      "Scheme/Stress order=USF"]),
    ("space, hexahedra, APIC", "wall_hexahedra.prm",
     [*CUBES, "End time=0.05", "Scheme/Velocity update=APIC",
      "Scheme/Gradient damping rate=1000"]),
    ("space, moving least squares, METIS, USF", "wall.prm",
     [COARSE, "End time=0.02", METIS, "Scheme/Stress order=USF",
      "Scheme/Averaging=moving least squares"]),
    ("space, FMPM", "wall.prm",
     [COARSE, "End time=0.02", "Scheme/Velocity update=FMPM"]),
    ("plane, USF", "wall_2d.prm", ["End time=0.02", "Scheme/Stress order=USF"]),
    ("space, METIS, USL", "wall.prm",
     [COARSE, "End time=0.02", METIS, "Scheme/Stress order=USL"])]
for number, (name, file, settings) in enumerate(CASES[:5] if IS_DEBUG else
                                                CASES):
    settings = [*settings, "Output/Interval=0"]
    one = run(INPUTS / file, *settings)
    # What three processes share in one way or another two do, too: that is tried
    # once for each kind of mesh and partition. Seven, on two cores, take their time.
    for ranks in (3,) if number > 2 else (2, 3) if IS_DEBUG or number > 1 else (2, 3, 7):
        other = run(INPUTS / file, *settings, ranks=ranks)
        where = f"{name}, {ranks} processes"
        checks.that(other.exit_code == 0, where, other.text[-2000:])
        check_same(where, one, other, ["points"], 0.)
        check_same(where, one, other, ["mass", "kinetic_energy"], 1e-12)
        check_same(where, one, other,
                   ["front", "height", "area", "potential_energy",
                    "elastic_energy", "transfer_loss"], 1e-9)

# A load at the boundary and a force of place, counted once.
LOADED = """
set Dimension = 2
set End time  = 0.05
{mesh}
{body}
{conditions}
subsection Boundary conditions
  subsection top
    set Traction = 0; -1000
  end
end
subsection Body force
  set Force = 3*y; 2*x
end
"""
for kind in KINDS:
    loaded = LOADED.format(
        mesh=box(2, [0., 0.], (2., 1.), (16, 8), kind),
        body=body(2, [0., 0.], (2., 1.), material=ELASTIC.format(
            density=1000, young=1e6, poisson=.3)),
        conditions=boundaries(walls=("roller", ["x_min", "x_max", "y_min"]),
                              top=("traction", ["y_max"])))
    one, three = run(loaded), run(loaded, ranks=3)
    checks.that(one.exit_code == three.exit_code == 0, f"a load, {kind}",
                one.text[-2000:] + three.text[-2000:])
    check_same(f"a load, {kind}", one, three,
               ["kinetic_energy", "boundary_work"], 1e-9)

if not IS_DEBUG:
    # The whole collapse: the points go three times as far as they were wide.
    for kind, settings in zip(KINDS, ([], SQUARES)):
        one, three = (run(INPUTS / "wall_2d.prm", *settings,
                          "Output/Interval=0", ranks=ranks) for ranks in (1, 3))
        check_same(f"the deposit, {kind}", one, three, ["front", "height"], .02)
        checks.that(abs(three.last("closure")) < 2e-3,
                    f"the ledger on three processes, {kind}",
                    str(three.last("closure")))
        performance = three.manifest["performance"]
        checks.that(performance["largest_imbalance"] < .1 and
                    performance["redistributions"] > 0,
                    f"the load stays even, {kind}", str(performance))
    # A process that gains points gets less than its share, so that shares last
    # longer: with equal ones cells were shared out six times here, now three.
    result = run(INPUTS / "wall_hexahedra.prm", "Output/Interval=1", "End time=0.7",
                 ranks=2)
    performance = result.manifest["performance"]
    checks.that(0 < performance["redistributions"] <= 4 and
                performance["largest_imbalance"] < .1,
                "the shares last", str(performance))

# One process has nothing to do, if there are more processes than cells.
for kind in KINDS:
    few = run(f"""
set Dimension = 2
set End time  = 0.01
{box(2, [0., 0.], (1., 1.), (1, 1), kind)}
{body(2, [0., 0.], (1., 1.), points_per_cell=1)}
{boundaries(walls=("roller", ["x_min", "x_max", "y_min"]),
            top=("free", ["y_max"]))}
""", ranks=3)
    checks.that(few.exit_code == 0, f"a process without points, {kind}",
                few.text[-2000:])

# Errors.
lost = run(escaping_body(), ranks=3)
checks.that(lost.exit_code == 2 and len(lost.errors) == 1 and
            "has left the mesh" in lost.errors[0] and
            lost.manifest.get("outcome") == "failed",
            "an error on one process", str(lost.exit_code) + lost.text[-2000:])
refused = run(INPUTS / "wall_2d.prm", "Time step/Type=fixed",
              "Time step/Fixed step=1", ranks=2)
checks.that(refused.exit_code == 1 and len(refused.errors) == 1 and
            not refused.manifest, "refused input", refused.text[-2000:])
checks.exit()
