"""Files of points and grid in every format, on 1, 2 and 3 processes, hold the same
numbers: bit for bit those of the VTU files on as many processes, and up to
round-off those of one process; every nth point is the same one everywhere; VTK
sees the cells as they are, and files without points; runs that were stopped and continued leave the same files; what cannot be written ends
the run with one message and the exit code."""

import os
import resource
import shutil
import subprocess
import time

import numpy

from vtkmodules.all import vtkCellSizeFilter  # its module depends on the version
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import (VTK_HEXAHEDRON, VTK_QUAD, VTK_TETRA,
                                           VTK_TRIANGLE)

from _case import Folder, escaping_body
from _fields import by_id, read_grid, read_series
from _program import PROGRAM, TIME_LIMIT
from _restart import IS_DEBUG, Case, checks, column, interrupted, same

END = ".02"
SHORT = ["Output/Interval=.01"]
PVTU = "Output/Format=PVTU"
COMPRESSED = "Output/Compression=fast"
FORMATS = {"VTU": ["Output/Format=VTU"],
           "PVTU": [PVTU],
           "PVTU of two ranks": [PVTU, "Output/Ranks per file=2"],
           "HDF5": ["Output/Format=HDF5"],
           "VTU with compression": [COMPRESSED],
           "HDF5 with compression": ["Output/Format=HDF5", COMPRESSED]}
MANY = ["Points/body/Points per cell=16"]
RANKS = ((1, 2, 3) if os.environ.get("MPM_MPIEXEC") and not IS_DEBUG else (1,))


def files_of(dim, settings, ranks):
    """What a run leaves: points, grid, and the names of the files."""
    with Folder() as folder:
        case = Case(folder, column(dim, end=END), [*SHORT, *settings], ranks)
        case.run(*case.start("--set=Checkpoint/At end=false"))
        return (read_series(case.path), read_series(case.path, "grid"),
                sorted(folder.files()))


def compare_points(name, series, reference, tolerance=0.):
    """Whether two runs wrote the same points at the same times."""
    checks.that(len(series) == 3 and
                [time for time, _ in series] == [time for time, _ in reference],
                f"{name}: times", f"{[time for time, _ in series]}")
    for (time, some), (_, others) in zip(series, reference):
        some, others = by_id(some), by_id(others)
        checks.that(some.keys() == others.keys() and len(some) >= 15,
                    f"{name}: fields", f"{sorted(some)} {sorted(others)}")
        for field in some.keys() & others.keys():
            a, b = some[field].astype(float), others[field].astype(float)
            agree = a.shape == b.shape and len(a) > 0 and numpy.all(
                abs(a - b) <= tolerance * abs(b).max())
            checks.that(agree, f"{name}, {time} s: {field}", f"{a} {b}")


def compare_grids(name, series, reference):
    """Whether two runs wrote the same grids, nodes and cells in the same order."""
    checks.that(len(series) == len(reference) == 3, f"{name}: grids")
    for (time, some), (_, others) in zip(series, reference):
        checks.that(some.keys() == others.keys() and
                    all(numpy.array_equal(some[field], others[field])
                        for field in others) and others["mass"].max() > 0.,
                    f"{name}, {time} s: grid")


for dim in (2, 3):
    numbers = RANKS if dim == 2 else {1, RANKS[-1]}
    reference = {ranks: files_of(dim, FORMATS["VTU"], ranks) for ranks in numbers}
    for ranks in RANKS if dim == 2 else RANKS[-1:]:
        # Round-off between numbers of processes, rounded to single precision.
        compare_points(f"{dim}D, VTU on {ranks}", reference[ranks][0],
                       reference[1][0], 0. if ranks == 1 else 1e-6)
        for name, settings in FORMATS.items():
            if name == "VTU" or "with comp" in name and ranks != RANKS[-1]:
                continue
            points, grid, files = files_of(dim, settings, ranks)
            where = f"{dim}D, {name} on {ranks}"
            compare_points(where, points, reference[ranks][0])
            compare_grids(where, grid, reference[ranks][1])
            n_pieces = sum("points-00001-" in file for file in files)
            expected = (0 if PVTU not in settings else
                        ranks if len(settings) == 1 else (ranks + 1) // 2)
            checks.that(n_pieces == expected, f"{where}: pieces", str(files))

every = "Output/Every nth point=7"
for name, ranks in (("VTU", 1), ("PVTU", RANKS[-1]), ("HDF5", RANKS[-1])):
    points, _, _ = files_of(3, [*FORMATS[name], every], ranks)
    every_seventh = [(time, {field: values[fields["id"] % 7 == 0]
                             for field, values in fields.items()})
                     for time, fields in reference[ranks][0]]
    n_points = len(points[0][1]["id"])
    checks.that(n_points == -(-len(reference[ranks][0][0][1]["id"]) // 7),
                "every 7th point: number", str(n_points))
    compare_points(f"every 7th point, {name}", points, every_seventh)

# The cells as VTK sees them: their shape, and sizes that add up to the mesh's.
SHAPES = {(2, "simplices"): VTK_TRIANGLE, (2, "hypercubes"): VTK_QUAD,
          (3, "simplices"): VTK_TETRA, (3, "hypercubes"): VTK_HEXAHEDRON}
for (dim, kind), shape in SHAPES.items():
    for name, settings in (("VTU", FORMATS["VTU with compression"]),
                           ("PVTU", FORMATS["PVTU"])):
        with Folder() as folder:
            case = Case(folder, column(dim, kind, "0"), settings, RANKS[-1])
            case.run(*case.start("--set=Checkpoint/At end=false"))
            sizes = vtkCellSizeFilter()
            sizes.SetInputData(read_grid(next(
                case.path.glob("grid/grid-00000." + name.lower()))))
            sizes.Update()
            grid = sizes.GetOutput()
            volumes = vtk_to_numpy(grid.GetCellData().GetArray(
                "Area" if dim == 2 else "Volume"))
            expected = .6 * .5 * (1. if dim == 2 else .1)
            types = {grid.GetCellType(i) for i in range(grid.GetNumberOfCells())}
            units = [grid.GetPointData().GetArray(field).GetInformation().Get(
                vtkDataArray.UNITS_LABEL()) for field in ("velocity", "mass")]
            checks.that(types == {shape} and volumes.min() > 0. and
                        abs(volumes.sum() / expected - 1.) < 1e-6 and
                        (name == "PVTU" or units[0] == "m/s"),
                        f"{dim}D, {kind}, {name}: cells",
                        f"{types} {volumes.min()} {volumes.sum()} {units}")

# One of the lowest points alone, on one of the ranks; none, when it has left.
ONE_POINT = escaping_body().replace(
    "set Names = body", "set Names = body\n  set Remove lost points = true")
for ranks in {1, RANKS[-1]}:
    for name, settings in FORMATS.items():
        if name == "PVTU of two ranks" and ranks == 1:
            continue
        with Folder() as folder:
            case = Case(folder, ONE_POINT, [
                *settings, "End time=.3", "Output/Interval=.1",
                "Output/Every nth point=441"], ranks)
            case.run(*case.start("--set=Checkpoint/At end=false"))
            series = read_series(case.path)
            numbers = [len(fields["position"]) for _, fields in series]
            checks.that(numbers == [1, 1, 1, 0] and
                        series[0][1]["id"].tolist() == [441],
                        f"{name} on {ranks}: one point, then none", str(numbers))

# Stopped and continued, with other ranks for the files to come: the record is
# complete and names no file that is gone.
for name in ("PVTU of two ranks", "HDF5"):
    settings = ["Output/Interval=.01", *FORMATS[name]]
    with Folder() as folder:
        whole = Case(folder, column(2), settings, RANKS[-1])
        whole.run(*whole.start())
        reference = whole.results()
        complete = read_series(whole.path)
        shutil.rmtree(whole.path)
        case = Case(folder, column(2), settings, RANKS[-1])
        checks.that(interrupted(case) == 3, f"{name}: interrupted")
        shutil.copytree(case.path, folder.path / "stopped")
        case.run("--resume", "out")
        same(f"{name}, resumed", case.results(), reference)

        shutil.rmtree(case.path)
        shutil.copytree(folder.path / "stopped", case.path)
        n_before = len(read_series(case.path))
        case.ranks = 1
        case.run("--resume", "out", "--set=Output/Point fields=id,velocity")
        series = read_series(case.path)
        checks.that([time for time, _ in series] ==
                    [time for time, _ in complete] and
                    "mass" in series[0][1] and "mass" not in series[-1][1] and
                    all(numpy.array_equal(numpy.sort(some["id"]),
                                          numpy.sort(other["id"]))
                        for (_, some), (_, other) in zip(series, complete)),
                    f"{name}, resumed on one process with other fields",
                    f"{n_before} {len(series)}")

        message = case.run("--resume", "out", "--set=Output/Format=VTU",
                           expected=1).stderr
        checks.that("Output/Format" in message and message.count("error:") == 1,
                    f"{name}: the format cannot be changed", message)


def check_failure(name, case, exit_code, message):
    """Whether a run that could not write a file of points ended with exit code 2
    and one message, and what the record names is complete."""
    errors = [line for line in message.splitlines()
              if "mpm_granular: error" in line]
    checks.that(exit_code == 2 and len(errors) == 1 and
                "Cannot write" in errors[0] and "points-0000" in errors[0],
                f"{name}: one message", f"{exit_code} {message}")
    checks.that(case.manifest()["outcome"] == "failed", f"{name}: manifest",
                str(case.manifest()))
    series = read_series(case.path)
    checks.that(series[0][0] == 0. and len(series[-1][1]["id"]) > 500,
                f"{name}: what was written before", str(len(series)))


def obstacle(name, file):
    """There is a folder where a file of the second instant is to be."""
    with Folder() as folder:
        case = Case(folder, column(2, end=END), [*SHORT, *FORMATS[name], *MANY],
                    RANKS[-1])
        (case.path / "points" / file / "in the way").mkdir(parents=True)
        result = folder.run(*case.start("--overwrite"), before=case.before())
        check_failure(f"{name}, obstacle", case, result.returncode,
                      result.stderr)


def full_disk(name):
    """After its start a run can only write files of 20 kB: what a full disk
    looks like."""
    with Folder() as folder:
        case = Case(folder, column(2, end="100"), [
            *SHORT, *FORMATS[name], *MANY, "Output/Observables interval=1"])
        # Python ignores the signal that comes with the limit; so does the run.
        with subprocess.Popen([PROGRAM, *case.start()], cwd=folder.path,
                              stdout=subprocess.DEVNULL, text=True,
                              stderr=subprocess.PIPE,
                              restore_signals=False) as process:
            record = "points.xdmf" if name == "HDF5" else "points.pvd"
            deadline = time.time() + TIME_LIMIT
            while (process.poll() is None and time.time() < deadline and
                   not (case.path / record).exists()):
                time.sleep(.01)
            resource.prlimit(process.pid, resource.RLIMIT_FSIZE, (20000, 20000))
            message = process.communicate(timeout=TIME_LIMIT)[1]
        check_failure(f"{name}, full disk", case, process.returncode, message)


# Of one of the processes with PVTU.
obstacle("VTU", "points-00001.vtu.tmp")
obstacle("PVTU", f"points-00001-000{RANKS[-1] - 1}.vtu.tmp")
obstacle("HDF5", "points-00001.h5.tmp")
full_disk("VTU")
full_disk("HDF5")
checks.exit()
