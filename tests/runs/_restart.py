"""Runs that are stopped and continued, for the tests of it, which import this
file."""

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

from _case import (IS_DEBUG, Checks, Folder, body, boundaries, box, on_ranks,
                   points_per_cell)
from _program import PROGRAM, TIME_LIMIT

checks = Checks()
SEED = random.randrange(1000000)
random.seed(SEED)
RESULTS = ["observables.csv", "profile.csv", "points.*", "points/*", "grid.*",
           "grid/*"]
END = "0.1" if IS_DEBUG else "0.15"
OFTEN = ["--set=Checkpoint/Step interval=10", "--set=Checkpoint/Number kept=3"]


def column(dim, kind="simplices", end=END):
    """A column of sand that collapses: points cross cells, some leave the mesh
    at its open end, and the time step changes."""
    up = "z" if dim == 3 else "y"
    sides = ["y_min", "y_max"] if dim == 3 else []
    thick = [.1] if dim == 3 else []
    return f"""
set Dimension = {dim}
set End time  = {end}
{box(dim, [0., *thick[:0], *([0.] * (dim - 1))], [.6, *thick, .5],
     [12, *([2] * (dim - 2)), 10], kind)}
{body(dim, [0., 0., 0.], [.2, *thick, .4], points_per_cell(dim, kind))
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
        return on_ranks(self.ranks)

    def run(self, *arguments, expected=0):
        """Runs to the end."""
        result = self.folder.run(*arguments, before=self.before())
        checks.that(result.returncode == expected, f"exit code of {arguments}",
                    f"{result.returncode} {result.stdout[-2000:]}{result.stderr}")
        return result

    def stop(self, which, *arguments, rows=None, is_ready=lambda: True):
        """Sends a signal when there are so many rows, or some time after the
        run has begun to write and is ready; waits for the end. The exit code."""
        table = self.path / "observables.csv"
        before = self.begin()
        with subprocess.Popen([*self.before(), PROGRAM, *arguments],
                              cwd=self.folder.path, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True) as process:
            deadline = time.time() + TIME_LIMIT
            while process.poll() is None and time.time() < deadline:
                if self.begin() != before and is_ready() and (
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


def kill(case, n_times, look=lambda: None):
    """Kills a run at random moments after its first checkpoint, so many times,
    and continues it each time; a run that is done meanwhile begins anew. `look`
    looks at what is there after each kill. The arguments to go on with, and the
    number of kills."""
    new = case.start("--set=Checkpoint/Step interval=3")
    arguments, n_killed = new, 0
    while n_killed < n_times:
        code = case.stop(signal.SIGKILL, *arguments, is_ready=case.checkpoints)
        if code == -signal.SIGKILL:
            n_killed += 1
            look()
            arguments = ["--resume", "out"]
        elif code == 0:
            arguments = new
            shutil.rmtree(case.path)
        else:
            break
    return arguments, n_killed


def same(name, results, reference):
    """Whether two runs left the same."""
    different = sorted(file for file in results.keys() | reference.keys()
                       if results.get(file) != reference.get(file))
    checks.that(not different and len(reference) > 5, f"{name}: same files",
                f"{different}; seed {SEED}")


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
