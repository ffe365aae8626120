"""A run that was interrupted and continued leaves the same files, bit for bit, as
one that was not: after SIGTERM, after SIGKILL at any moment, in 2D and 3D, with
every scheme, on several processes."""

import os
import shutil
import signal

from _case import Folder
from _restart import (IS_DEBUG, OFTEN, Case, agree, checks, column, interrupted,
                      kill, same, uninterrupted)


def interrupt(name, dim, settings=()):
    """SIGTERM, then resumed; checkpoints, which both parts write, do not change
    the run."""
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


def with_checkpoints(dim):
    """The same of a run that nothing interrupts."""
    with Folder() as folder:
        case = Case(folder, column(dim))
        case.run(*case.start(*OFTEN))
        same(f"{dim}D: with checkpoints", case.results(),
             uninterrupted(column(dim)))


def several_ranks(dim, kind):
    """Stopped on two ranks, a run goes on bit for bit on two; stopped on one, on
    three and from there on two, up to the growth of round-off."""
    name = f"{dim}D, {kind}"
    with Folder() as folder:
        case = Case(folder, column(dim, kind), ranks=2)
        case.run(*case.start())
        reference = case.results()
    with Folder() as folder:
        case = Case(folder, column(dim, kind), ranks=2)
        code = interrupted(case)
        checks.that(code == 3, f"{name}, two ranks: interrupted", str(code))
        case.run("--resume", "out")
        same(f"{name}, two ranks: resumed", case.results(), reference)
    with Folder() as folder:
        case = Case(folder, column(dim, kind))
        code = interrupted(case)
        checks.that(code == 3, f"{name}, one rank: interrupted", str(code))
        case.ranks = 3
        code = case.stop(signal.SIGTERM, "--resume", "out", rows=16)
        print(f"{name}: on three ranks the run "
              f"{'was stopped' if code == 3 else 'came to its end'}")
        case.ranks = 2
        case.run("--resume", "out")
        agree(f"{name}, one, three, two ranks", case.results(), reference)


def killed(dim, n_times):
    """SIGKILL at any moment, again and again."""
    reference = uninterrupted(column(dim))
    with Folder() as folder:
        case = Case(folder, column(dim))
        arguments, n_killed = kill(case, n_times)
        checks.that(n_killed == n_times, f"{dim}D: killed", str(n_killed))
        case.run(*arguments)
        same(f"{dim}D killed", case.results(), reference)
        left = [file for file in folder.files() if file.endswith(".tmp")]
        checks.that(not left, f"{dim}D killed: no temporary files", str(left))


def finished():
    """Continued at its end, a run writes its last output once more, the same."""
    reference = uninterrupted(column(2))
    with Folder() as folder:
        case = Case(folder, column(2))
        case.run(*case.start())
        case.run("--resume", "out")
        same("finished and resumed", case.results(), reference)


def on_demand():
    """SIGUSR1: a checkpoint, and the run goes on."""
    with Folder() as folder:
        case = Case(folder, column(2))
        code = case.stop(signal.SIGUSR1, *case.start(
            "--set=Checkpoint/At end=false", "--set=Output/Interval=1e-3"),
                         rows=3)
        checks.that(code == 0 and len(case.checkpoints()) == 1, "SIGUSR1",
                    f"{code} {case.checkpoints()}")


for dimension in (2, 3):
    interrupt(f"{dimension}D", dimension)
    with_checkpoints(dimension)
SCHEMES = (["Scheme/Mass matrix=near-consistent"],
           ["Scheme/Averaging=nodes", "Scheme/Pressure filter rate=100"],
           ["Scheme/Averaging=moving least squares"],
           ["Scheme/Averaging=automatic"],
           ["Scheme/Stress order=USF", "Scheme/Averaging=nodes"],
           ["Scheme/Velocity update=APIC", "Scheme/Averaging=nodes",
            "Scheme/Position shift rate=10"],
           ["Time step/Type=fixed", "Time step/Fixed step=2e-4"])
for scheme in SCHEMES[:3] if IS_DEBUG else SCHEMES:
    interrupt(" ".join(scheme), 2, tuple(scheme))
if os.environ.get("MPM_MPIEXEC"):
    # The other two kinds are in adaptive_restart.py.
    several_ranks(2, "simplices")
    several_ranks(3, "hypercubes")
if IS_DEBUG:  # in Release kills.py does so
    killed(2, 2)
killed(3, 1 if IS_DEBUG else 3)
finished()
on_demand()
checks.exit()
