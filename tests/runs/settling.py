"""The stage before time 0 finds stresses in equilibrium for any filling: lattices
that fit the mesh or do not, unstructured meshes, sloping ground, a slope, with the
averages and the pressure filter of the default. After it points accelerate by less
than 1 % of gravity (they begin with several g, see rest_state.py) and stay at rest;
the stresses are those of the closed forms. A body
that cannot stand ends the run with exit code 2. A checkpoint of the stage continues
it bit for bit."""

import os

from _case import (INPUTS, IS_DEBUG, KINDS, Checks, Folder, Result, body, boundaries,
                   box, on_ranks, points_per_cell, rollers, run)

checks = Checks()
GRAVITY = 9.81
STAGE = """
subsection Initial equilibrium
  set Enabled = true
end
subsection Output
  set Interval             = 0
  set Observables interval = 0
end
"""


def column(dim, kind, layout=None, walls=None):
    """1 m of sand between smooth walls; points as usual or in another layout."""
    usual = f"set Points per cell = {points_per_cell(dim, kind)}"
    up = [1., .4, 1.] if dim == 3 else [1., 1.]
    cells = [5, 2, 6] if dim == 3 else [10, 12]
    top = [1., .4, 1.2] if dim == 3 else [1., 1.2]
    return f"""
set Dimension = {dim}
set End time  = 0.05
{box(dim, [0.] * dim, top, cells, kind)}
{body(dim, [0.] * dim, up, points_per_cell(dim, kind)).replace(
    usual, layout or usual)}
{walls or rollers(dim)}
{STAGE}"""


def lattice(dim, spacing):
    return f"""set Layout = lattice
    set Spacing = {', '.join([str(spacing)] * dim)}"""


def start(result):
    """The index of the row of time 0."""
    return result["time"].index(0.)


def is_at_rest(name, result, motion_limit=1e-5):
    """Judges the run after the stage, and the stage's rows and words.

    motion_limit: of kinetic over elastic energy."""
    checks.that(result.exit_code == 0 and "Initial equilibrium after" in result.text,
                f"{name}: settles", result.text[-2000:])
    if result.exit_code != 0:
        return
    row = start(result)
    acceleration = result["max_speed"][row + 1] / result["dt"][row + 1] / GRAVITY
    motion = max(result["kinetic_energy"][row:]) / result["elastic_energy"][row]
    said = next(line for line in result.text.splitlines()
                if "Initial equilibrium after" in line)
    print(f"{name}: {acceleration:.2e} g, kinetic over elastic energy "
          f"{motion:.1e}\n  {said}", flush=True)
    checks.that(acceleration < .01, f"{name}: at rest", f"{acceleration} g")
    checks.that(motion < motion_limit, f"{name}: stays at rest", str(motion))
    times = result["time"]
    checks.that(times == sorted(set(times)) and times[0] == -10. and row > 1,
                f"{name}: times", str(times[:3]))
    checks.that(result["kinetic_energy"][row] == 0. and
                result["damping"][row] == 0. and result["closure"][row] == 0. and
                result["damping"][row - 1] > 0.,
                f"{name}: begins anew", "energies at time 0")
    checks.that(result["center_x"][row] == result["center_x"][0],
                f"{name}: points stay in the stage")


for dim in (2, 3):
    for kind in KINDS:
        for spacing in (.05,) if IS_DEBUG else (.05, .037):
            size = spacing * (2 if dim == 3 else 1)
            name = f"{dim}D, {kind}, lattice of {size} m"
            result = run(column(dim, kind, lattice(dim, size)))
            is_at_rest(name, result)
            if spacing != .05 or result.exit_code != 0:
                continue
            # With 1.6 points a tetrahedron means in cells are in balance with
            # uneven pressures, whose energy is 1.4 times as large.
            if dim == 3 and kind == "simplices":
                result = run(column(dim, kind, lattice(dim, size)),
                             "Scheme/Averaging=none")
            # Uniaxial strain under the weight: sigma_v^2/(2M) per volume.
            modulus = 1e6 * .7 / (1.3 * .4)
            area = .4 if dim == 3 else 1.
            expected = area * (1500 * GRAVITY)**2 / (6 * modulus)
            energy = result["elastic_energy"][start(result)]
            checks.that(abs(energy / expected - 1.) < .03, f"{name}: energy",
                        f"{energy} instead of {expected}")
            # What gravity did, counted as work of the boundary, is stored or
            # gone: closure is over the potential energy.
            stage = result["closure"][:start(result)]
            checks.that(max(map(abs, stage)) < 1e-3, f"{name}: closure",
                        str(stage[-1]))

ground = boundaries(ground=("clamp", ["y_min"]), sides=("roller", ["x_min", "x_max"]),
                    top=("free", ["y_max"]))
# Some points of the surface come into contact, and the filter moves them.
for rate, motion_limit in ("0", 1e-5), ("automatic", 2e-4):
    is_at_rest(f"2D, ground at 15 degrees, filter {rate}", run(
        column(2, "simplices", lattice(2, .037), ground),
        "Body force/Gravity=2.539, -9.4757", f"Scheme/Pressure filter rate={rate}"),
               motion_limit=motion_limit)
is_at_rest("2D, bin with rough walls that only push", run(
    column(2, "simplices", lattice(2, .037), boundaries(
        walls=("Coulomb friction", ["x_min", "x_max", "y_min"]),
        top=("free", ["y_max"])))))
if not IS_DEBUG:
    is_at_rest("2D, near-consistent mass, USL", run(
        column(2, "simplices", lattice(2, .037)),
        "Scheme/Mass matrix=near-consistent", "Scheme/Stress order=USL"))
    is_at_rest("2D, slope", run(
        INPUTS / "slope_2d.prm", "End time=0.02", "Output/Observables interval=0",
        "Boundary conditions/ground/Velocity=0; 0",
        "Boundary conditions/back/Velocity=0; 0"))
    # A layer that cuts through the cells.
    is_at_rest("3D, lattice on tetrahedra of gmsh", run(
        INPUTS / "wall.prm", "Mesh/File=meshes/wall_coarse.msh",
        "Points/wall/Shape=box", "Points/wall/Lower corner=0, 0, 0",
        "Points/wall/Upper corner=4.2, 0.2, 0.72", "Points/wall/Layout=lattice",
        "Points/wall/Spacing=0.035, 0.04, 0.035", "Initial state/Stress=none",
        "Initial equilibrium/Enabled=true", "Scheme/Averaging=automatic",
        "Scheme/Pressure filter rate=automatic", "End time=0.02", "Output/Observables interval=0"))

# A steep face of dry sand does not stand.
result = run(column(2, "simplices", None, boundaries(
    base=("clamp", ["y_min"]), side=("roller", ["x_min"]),
    open=("free", ["x_max", "y_max"]))), "Initial equilibrium/Maximum time=1",
             "Mesh/Upper corner=2, 1.2", "Mesh/Subdivisions=20, 12",
             "Output/Observables interval=0.1")
checks.that(result.exit_code == 2 and "No initial equilibrium within" in result.text
            and "Is the body stable?" in result.text and result.last("time") <= 0.,
            "a steep face", result.text[-2000:])

refused = run(column(2, "simplices"), "Initial state/Velocity=0; -1")
checks.that(refused.exit_code == 1 and "Initial state/Velocity" in refused.text,
            "an initial velocity", refused.text)


def resumed(ranks_first, ranks_then, kind="simplices"):
    """Continues from a checkpoint of the stage."""
    with Folder() as folder:
        file = folder.path / "case.prm"
        file.write_text(column(2, kind, lattice(2, .037)), encoding="utf8")
        folder.run(file, "--output", "out", "--set=Checkpoint/Step interval=60",
                   "--set=Checkpoint/Number kept=100", before=on_ranks(ranks_first))
        table = folder.path / "out" / "observables.csv"
        reference, whole = table.read_bytes(), Result(
            folder.run("--version"), folder.path / "out")
        kept, *later = sorted((folder.path / "out" / "checkpoint").iterdir())
        for path in later:
            path.unlink()
        process = folder.run("--resume", "out", before=on_ranks(ranks_then))
        again = Result(process, folder.path / "out")
        name = f"{kind}, stage of {ranks_first} ranks, continued on {ranks_then}"
        checks.that(process.returncode == 0 and "step-0000000060" in kept.name and
                    "Initial equilibrium after" in process.stdout, name,
                    process.stdout[-2000:] + process.stderr)
        # Local damping asks for signs of velocities, which round-off decides where
        # there is none: other ranks come to an equilibrium by other steps.
        same = (table.read_bytes() == reference if ranks_first == ranks_then else
                abs(again.last("elastic_energy") / whole.last("elastic_energy") - 1)
                < 1e-3)
        checks.that(same, f"{name}: the same", "observables.csv differs")


resumed(1, 1)
if os.environ.get("MPM_MPIEXEC"):
    resumed(3, 3, "hypercubes")
    if not IS_DEBUG:
        resumed(1, 3)
checks.exit()
