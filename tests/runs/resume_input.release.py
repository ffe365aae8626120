"""What a run is continued from: damaged checkpoints are noticed and the one before
used; what --set may change and what not; files found from any folder."""

import os
import shutil
import subprocess

from _case import INPUTS, Folder
from _program import PROGRAM
from _restart import (OFTEN, Case, checks, column, interrupted, same,
                      uninterrupted)


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


damage()
change_entries()
other_folders()
checks.exit()
