#!/usr/bin/env python3
"""Short runs: what they leave, --overwrite, and what a signal does.

Usage: stop_and_overwrite.py [PROGRAM]
"""

import signal
import subprocess
import time

from _program import INPUTS, PROGRAM, TIME_LIMIT, Checks, Folder

CASE = INPUTS / "wall_2d.prm"
SHORT = ["--set=End time=1e-3", "--output", "there"]
checks = Checks()


def run_twice():
    """A run is done, not repeated in the same folder unless that is wanted."""
    with Folder() as folder:
        first = folder.run(CASE, *SHORT)
        checks.that(first.returncode == 0 and not first.stderr, "run", first)
        files = folder.files()
        for name in ("parameters.prm", "manifest.json", "observables.csv",
                     "points.pvd", "log.txt"):
            checks.that(f"there/{name}" in files, f"{name} is written", files)
        text = (folder.path / "there" / "parameters.prm").read_text()
        checks.that("set End time = 1e-3" in text, "parameters as used", text)

        second = folder.run(CASE, *SHORT)
        checks.that(second.returncode == 1 and folder.files() == files,
                    "second run", second)
        third = folder.run(CASE, *SHORT, "--overwrite")
        checks.that(third.returncode == 0, "run with --overwrite", third)


def stop(which, expected):
    """A run that gets a signal ends after its step, with its state written."""
    with Folder() as folder:
        with subprocess.Popen(
                [PROGRAM, CASE, "--set=End time=1000", "--output", "there"],
                cwd=folder.path, stdout=subprocess.DEVNULL,
                stderr=subprocess.PIPE, text=True) as process:
            table = folder.path / "there" / "observables.csv"
            deadline = time.time() + TIME_LIMIT
            while (process.poll() is None and time.time() < deadline and
                   not (table.exists() and table.read_text().count("\n") > 1)):
                time.sleep(0.1)
            process.send_signal(which)
            try:
                message = process.communicate(timeout=TIME_LIMIT)[1]
            except subprocess.TimeoutExpired:
                process.kill()
                message = "does not stop"
        checks.that(process.returncode == expected, f"{which.name}: exit code",
                    f"{process.returncode} {message}")
        manifest = (folder.path / "there" / "manifest.json").read_text()
        checks.that("interrupted" in manifest, f"{which.name}: manifest",
                    manifest)
        files = folder.files()
        checks.that(not any(name.endswith(".tmp") for name in files) and
                    any(name.endswith(".vtu") for name in files),
                    f"{which.name}: files", files)


run_twice()
stop(signal.SIGINT, 3)
stop(signal.SIGTERM, 3)
checks.exit()
