"""A run that was interrupted and continued leaves the same files, bit for bit, as
one that was not: after SIGTERM, after SIGKILL at any moment, with damaged
checkpoints, in 2D and 3D, with every scheme. And what is refused."""

import functools
import json
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import time

from _case import INPUTS, SAND, Checks, Folder, body, boundaries, box
from _program import PROGRAM, TIME_LIMIT

checks = Checks()
IS_DEBUG = os.environ.get("MPM_BUILD_TYPE") == "Debug"
SEED = random.randrange(1000000)
random.seed(SEED)
RESULTS = ["observables.csv", "profile.csv", "points.pvd", "points/*.vtu",
           "grid.pvd", "grid/*.vtu"]
END = "0.1" if IS_DEBUG else "0.15"
OFTEN = ["--set=Checkpoint/Step interval=10", "--set=Checkpoint/Number kept=3"]


def column(dim, end=END):
    """A column of sand that collapses: points cross cells, some leave the mesh
    at its open end, and the time step changes."""
    up = "z" if dim == 3 else "y"
    sides = ["y_min", "y_max"] if dim == 3 else []
    thick = [.1] if dim == 3 else []
    return f"""
set Dimension = {dim}
set End time  = {end}
{box(dim, [0., *thick[:0], *([0.] * (dim - 1))], [.6, *thick, .5],
     [12, *([2] * (dim - 2)), 10])}
{body(dim, [0., 0., 0.], [.2, *thick, .4], material=SAND)
 .replace("set Names = body", "set Names = body" + chr(10) +
          "  set Remove lost points = true")}
{boundaries(base=("clamp", [up + "_min"]), sides=("roller", ["x_min", *sides]),
            open=("free", ["x_max", up + "_max"]))}
subsection Initial state
  set Velocity = {"4; 0" if dim == 2 else "4; 0; 0"}
end
subsection Scheme
  set Pressure filter rate = 100
end
subsection Output
  set Interval             = 0.02
  set Observables interval = 0.003
  set Write grid           = true
end
"""


class Case:
    """A run in a folder of its own."""

    def __init__(self, folder, text, settings=(), ranks=1):
        self.folder = folder
        self.ranks = ranks
        self.path = folder.path / "out"
        (folder.path / "case.prm").write_text(text, encoding="utf8")
        self.settings = [f"--set={setting}" for setting in settings]

    def start(self, *options):
        """The arguments of a new run."""
        return ["case.prm", "--output", "out", *self.settings, *options]

    def before(self):
        """What is put in front of the program."""
        return [os.environ["MPM_MPIEXEC"], "-np", str(self.ranks)
                ] if self.ranks > 1 else []

    def run(self, *arguments, expected=0):
        """Runs to the end."""
        result = self.folder.run(*arguments, before=self.before())
        checks.that(result.returncode == expected, f"exit code of {arguments}",
                    f"{result.returncode} {result.stdout[-2000:]}{result.stderr}")
        return result

    def stop(self, which, *arguments, rows=None):
        """Sends a signal when there are so many rows, or some time after the
        run has begun to write; waits for the end. The exit code."""
        table = self.path / "observables.csv"
        before = self.begin()
        with subprocess.Popen([*self.before(), PROGRAM, *arguments],
                              cwd=self.folder.path, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True) as process:
            deadline = time.time() + TIME_LIMIT
            while process.poll() is None and time.time() < deadline:
                if self.begin() != before and (
                        rows is None or table.exists() and
                        table.read_text().count("\n") > rows):
                    break
                time.sleep(.002)
            if rows is None:
                time.sleep(random.uniform(0., .3))
            if self.ranks == 1:
                process.send_signal(which)
            else:
                # One rank gets it, and tells the others.
                pid = process.pid
                os.kill(int(pathlib.Path(f"/proc/{pid}/task/{pid}/children")
                            .read_text().split()[-1]), which)
            message = process.communicate(timeout=TIME_LIMIT)[1]
        if process.returncode not in (0, 3, -signal.SIGKILL):
            checks.that(False, f"{which.name}: exit code", message)
        return process.returncode

    def begin(self):
        """When the manifest was written, at the start of the run."""
        manifest = self.path / "manifest.json"
        return manifest.stat().st_mtime_ns if manifest.exists() else 0

    def checkpoints(self):
        """The files, the newest first."""
        return sorted((self.path / "checkpoint").glob("*.h5"), reverse=True)

    def results(self):
        """What must not depend on interruptions."""
        def content(path):
            # deal.II writes the date into a comment.
            return re.sub(rb"<!--.*?-->", b"", path.read_bytes(), flags=re.S)

        return {str(path.relative_to(self.path)): content(path)
                for pattern in RESULTS for path in self.path.glob(pattern)}

    def manifest(self):
        return json.loads((self.path / "manifest.json").read_text())


def same(name, results, reference):
    """Whether two runs left the same."""
    different = sorted(file for file in results.keys() | reference.keys()
                       if results.get(file) != reference.get(file))
    checks.that(not different and len(reference) > 5, f"{name}: same files",
                f"{different}; seed {SEED}")


@functools.lru_cache
def uninterrupted(text, settings=()):
    """The results of a run without checkpoints."""
    with Folder() as folder:
        case = Case(folder, text, settings)
        case.run(*case.start("--set=Checkpoint/Wall time interval=0",
                             "--set=Checkpoint/At end=false"))
        checks.that(not case.checkpoints(), "no checkpoints unless asked for")
        return case.results()


def interrupted(case):
    """Stops a run by SIGTERM when it has eight rows; one that is done too early
    is repeated with more checkpoints, which take time. The exit code."""
    for interval in (10, 3, 1):
        code = case.stop(signal.SIGTERM, *case.start(
            f"--set=Checkpoint/Step interval={interval}",
            "--set=Checkpoint/Number kept=3"), rows=8)
        if code == 3:
            break
        if interval > 1:
            shutil.rmtree(case.path)
    return code


def interrupt(name, dim, settings=()):
    """SIGTERM, then resumed; checkpoints do not change the run."""
    reference = uninterrupted(column(dim), settings)
    with Folder() as folder:
        case = Case(folder, column(dim), settings)
        code = interrupted(case)
        checks.that(code == 3, f"{name}: interrupted", str(code))
        stopped = case.manifest()
        checks.that(stopped["outcome"] == "interrupted" and case.checkpoints(),
                    f"{name}: checkpoint at the stop", str(stopped))
        result = case.run("--resume", "out")
        same(f"{name}: resumed", case.results(), reference)
        manifest = case.manifest()
        step = stopped["counts"]["steps"]
        checks.that(len(manifest["resumed"]) == 1 and
                    f"step {step}," in manifest["resumed"][0] and
                    manifest["outcome"] == "done",
                    f"{name}: manifest", str(manifest))
        log = (case.path / "log.txt").read_text()
        checks.that(log.count("stability limit") == 2 and
                    f"Continues from step {step}" in log and
                    f"Continues from step {step}" in result.stdout,
                    f"{name}: log", log)
        checks.that(len(case.checkpoints()) == 3, f"{name}: checkpoints kept",
                    str(case.checkpoints()))
    with Folder() as folder:
        case = Case(folder, column(dim), settings)
        case.run(*case.start(*OFTEN))
        same(f"{name}: with checkpoints", case.results(), reference)


def several_ranks(dim):
    """Stopped on two ranks: goes on bit for bit on two, on others up to the
    growth of round-off."""
    with Folder() as folder:
        case = Case(folder, column(dim), ranks=2)
        case.run(*case.start())
        reference = case.results()
    with Folder() as folder:
        case = Case(folder, column(dim), ranks=2)
        code = interrupted(case)
        checks.that(code == 3, f"{dim}D, two ranks: interrupted", str(code))
        shutil.copytree(case.path, folder.path / "stopped")
        case.run("--resume", "out")
        same(f"{dim}D, two ranks: resumed", case.results(), reference)
        for ranks in (1, 3):
            shutil.rmtree(case.path)
            shutil.copytree(folder.path / "stopped", case.path)
            case.ranks = ranks
            case.run("--resume", "out")
            agree(f"{dim}D, {ranks} ranks", case.results(), reference)


def agree(name, results, reference):
    """Whether the tables of two runs are nearly the same: as many rows and
    points, and the values of the last row to a part in ten thousand."""
    tables = [table["observables.csv"].decode().split()
              for table in (results, reference)]
    names = tables[0][0].split(",")
    rows = [dict(zip(names, map(float, table[-1].split(",")))) for table in tables]
    different = [(n, rows[0][n], rows[1][n]) for n in names
                 if n not in ("closure", "transfer_loss", "dt", "step") and
                 abs(rows[0][n] - rows[1][n]) > 1e-4 * abs(rows[1][n])]
    checks.that(len(tables[0]) == len(tables[1]) and not different and
                results.keys() == reference.keys(),
                f"{name}: nearly the same", str(different))


def kill(dim, n_times):
    """SIGKILL at any moment, again and again."""
    reference = uninterrupted(column(dim))
    with Folder() as folder:
        case = Case(folder, column(dim))
        arguments, n_killed = case.start("--set=Checkpoint/Step interval=3"), 0
        for _ in range(n_times):
            if case.stop(signal.SIGKILL, *arguments) != -signal.SIGKILL:
                break
            n_killed += 1
            if case.checkpoints():
                arguments = ["--resume", "out"]
            else:
                shutil.rmtree(case.path)
        checks.that(n_killed > 0, f"{dim}D: killed at least once")
        print(f"{dim}D: killed {n_killed} times, resumed "
              f"{len(case.manifest()['resumed']) if case.path.exists() else 0}")
        case.run(*arguments)
        same(f"{dim}D killed", case.results(), reference)
        left = [file for file in folder.files() if file.endswith(".tmp")]
        checks.that(not left, f"{dim}D killed: no temporary files", str(left))


def damage():
    """The newest checkpoint is truncated or changed: the one before is used,
    with a message; none is left: refused, and nothing is touched."""
    def truncate(path):
        os.truncate(path, path.stat().st_size // 2)

    def change(path):
        data = bytearray(path.read_bytes())
        # At many places: HDF5 has bytes that mean nothing.
        for place in range(len(data) // 4, 3 * len(data) // 4, 97):
            data[place] ^= 1
        path.write_bytes(data)

    def empty(path):
        os.truncate(path, 0)

    reference = uninterrupted(column(2))
    for name, action in (("truncated", truncate), ("changed", change),
                         ("empty", empty)):
        with Folder() as folder:
            case = Case(folder, column(2))
            interrupted(case)
            newest, older = case.checkpoints()[:2]
            action(newest)
            result = case.run("--resume", "out")
            text = result.stdout + result.stderr
            checks.that(newest.name in text and older.name in text and
                        "cannot be used" in text, f"{name}: message", text)
            same(f"{name} checkpoint", case.results(), reference)

            for path in case.checkpoints():
                action(path)
            files = folder.files()
            message = case.run("--resume", "out", expected=1).stderr
            checks.that("no checkpoint" in message and files == folder.files(),
                        f"all {name}", message)


def change_entries():
    """What --set may change and what not."""
    with Folder() as folder:
        case = Case(folder, column(2, end=".03"))
        case.run(*case.start(*OFTEN))
        files = folder.files()
        for setting, *fragments in (
                ("Materials/sand/Young modulus=2e6", "1e6", "2e6"),
                ("Materials/sand/Law=linear elastic", "elastic"),
                ("Time step/CFL=0.3", "0.3"),
                ("Dimension=3", "Dimension"),
                ("Scheme/Pressure filter rate=0", "Pressure filter rate"),
                ("End time=0.01", "before"),
                ("Output/Directory=other", "another folder"),
                ("Materials/sand/Yung modulus=1", "'Young modulus'")):
            message = case.run("--resume", "out", "--set", setting,
                               expected=1).stderr
            entry = setting.split("=", maxsplit=1)[0]
            checks.that(all(part in message for part in fragments) and
                        (entry.split("/")[-1] in message or
                         "Directory" in entry) and
                        message.count("error:") == 1,
                        f"{setting}: message", message)
        checks.that(folder.files() == files, "refused: nothing is touched")
        for arguments in (["--resume", "nowhere"], ["--resume", "."],
                          ["case.prm", "--resume", "out"],
                          ["--resume", "out", "--overwrite"],
                          ["--resume", "out", "--output", "other"],
                          ["--resume", "out", "--print-parameters"]):
            case.run(*arguments, expected=1)

        result = case.run("--check", "--resume", "out")
        checks.that("Continues from" in result.stdout and
                    folder.files() == files, "--check", result.stdout)

        # Steps end on rows anyway: a run that goes on is a longer run.
        case.run("--resume", "out", "--set=End time=.06",
                 "--set=Checkpoint/Number kept=1")
        same("later end", case.results(), uninterrupted(column(2, end=".06")))
        checks.that(len(case.checkpoints()) == 1, "later end: number kept",
                    str(case.checkpoints()))

        case.run("--resume", "out", "--set=End time=.09",
                 "--set=Output/Interval=.005", "--set=Output/Write grid=false",
                 "--set=Observables/Run-out direction=-x")
        times = [float(row.split(",")[0]) for row in
                 (case.path / "observables.csv").read_text().split()[1:]]
        checks.that(times == sorted(times) and times[-1] == .09,
                    "other output: table", str(times))
        files = sorted(case.path.glob("points/*.vtu"))
        record = (case.path / "points.pvd").read_text()
        checks.that(len(files) > 9 and record.count(".vtu") == len(files),
                    "other output: points", record)


def other_folders():
    """Names of files count from the parameter file's folder, wherever the run
    is resumed; a run does not go on with another mesh."""
    with Folder() as folder:
        (folder.path / "inputs" / "meshes").mkdir(parents=True)
        (folder.path / "elsewhere").mkdir()
        shutil.copy(INPUTS / "wall_2d.prm", folder.path / "inputs")
        mesh = folder.path / "inputs" / "meshes" / "wall_2d.msh"
        shutil.copy(INPUTS / "meshes" / "wall_2d.msh", mesh)
        short = ["--set=End time=1e-3", "--set=Output/Observables interval=0"]
        case = Case(folder, "")
        case.run("inputs/wall_2d.prm", "--output", "out", *short)
        result = subprocess.run(
            [PROGRAM, "--resume", "../out", "--set=End time=2e-3"],
            cwd=folder.path / "elsewhere", capture_output=True, text=True,
            check=False)
        checks.that(result.returncode == 0, "resumed elsewhere", result.stderr)

        # The first number after the first node tags of the mesh, a coordinate.
        text = mesh.read_text()
        assert "0.05" in text
        mesh.write_text(text.replace("0.05", "0.0500001", 1))
        message = case.run("--resume", "out", "--set=End time=3e-3",
                           expected=1).stderr
        checks.that("mesh" in message, "other mesh", message)


def on_demand():
    """SIGUSR1: a checkpoint, and the run goes on."""
    with Folder() as folder:
        case = Case(folder, column(2))
        code = case.stop(signal.SIGUSR1, *case.start(
            "--set=Checkpoint/At end=false", "--set=Output/Interval=1e-3"),
                         rows=3)
        checks.that(code == 0 and len(case.checkpoints()) == 1, "SIGUSR1",
                    f"{code} {case.checkpoints()}")


interrupt("2D", 2)
interrupt("3D", 3)
for scheme in (["Scheme/Stress order=USF"],
               ["Scheme/Mass matrix=near-consistent"],
               ["Time step/Type=fixed", "Time step/Fixed step=2e-4"]):
    interrupt(" ".join(scheme), 2, tuple(scheme))
if os.environ.get("MPM_MPIEXEC"):
    several_ranks(2)
    several_ranks(3)
kill(2, 5)
kill(3, 3)
damage()
change_entries()
other_folders()
on_demand()
checks.exit()
