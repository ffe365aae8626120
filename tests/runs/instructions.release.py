#!/usr/bin/env python3
"""Counts the instructions of the time step; fails if there are more than before.

    instructions.release.py               # the test
    MPM_RENEW=1 instructions.release.py   # writes what it counts to the file

The program mpm_granular_counted, which is compiled for one kind of processor
whatever this machine has (x86-64-v3), runs small walls in motion under
valgrind's callgrind, which counts the instructions within the time step only.
tests/runs/_instructions.json has the numbers by compiler. A number is a
regression baseline, not a truth: where the step does more, or less, renew it in
the same commit.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

from _case import INPUTS, SOURCE_DIR, Checks, Folder

BUILD_DIR = pathlib.Path(os.environ["MPM_BUILD_DIR"])
REFERENCE = SOURCE_DIR / "tests" / "runs" / "_instructions.json"
ALLOWED_GROWTH = 0.05
STEP = "mpm_granular::Solver::MPMSolver<*>::advance_one_step*"

# In motion from the start, at about the speed of the collapse.
MOVING = "Initial state/Velocity=1.2*x; 0; -1.2*z"
COMMON = ["Output/Interval=10", "Output/Observables interval=10",
          "Scheme/Pressure filter rate=0"]
CASES = {
    "tetrahedra": ["Mesh/Cells=simplices", "Points/wall/Points per cell=4"],
    "cubes": [],
}
SETTINGS = ["Mesh/Subdivisions=20, 1, 11", MOVING, "End time=0.05"]


def build():
    """The program to count, or None where it cannot be built."""
    cache = (BUILD_DIR / "CMakeCache.txt").read_text()
    cmake = re.search(r"^CMAKE_COMMAND:INTERNAL=(.*)$", cache, re.M)[1]
    process = subprocess.run(
        [cmake, "--build", BUILD_DIR, "--target", "mpm_granular_counted"],
        capture_output=True, text=True, check=False)
    program = BUILD_DIR / "mpm_granular_counted"
    if process.returncode != 0 or not program.is_file():
        sys.exit(f"mpm_granular_counted was not built:\n{process.stdout}"
                 f"{process.stderr}")
    return program


def compiler_of(program):
    """Its name and first number of its version."""
    text = subprocess.run([program, "--version"], capture_output=True,
                          text=True, check=True).stdout
    return re.search(r"(GNU|Clang) \d+", text)[0]


def count(program, settings):
    """Instructions per point and step."""
    with Folder() as folder:
        options = [word for setting in COMMON + SETTINGS + settings
                   for word in ("--set", setting)]
        process = subprocess.run(
            ["valgrind", "--tool=callgrind", "--callgrind-out-file=counts",
             f"--toggle-collect={STEP}", program,
             INPUTS / "wall_hexahedra.prm", "--output", "out", *options],
            cwd=folder.path, capture_output=True, text=True, check=False)
        if process.returncode != 0:
            sys.exit(f"{process.stdout}{process.stderr}")
        n_instructions = int(re.search(r"Collected : (\d+)",
                                       process.stderr)[1])
        manifest = json.loads((folder.path / "out" /
                               "manifest.json").read_text())
        return n_instructions / manifest["point_steps"]


def main():
    if shutil.which("valgrind") is None:
        print("Not tested: valgrind is not installed (apt-get install "
              "valgrind).")
        return
    if "avx2" not in pathlib.Path("/proc/cpuinfo").read_text():
        print("Not tested: this processor has no AVX2, for which the program "
              "is compiled.")
        return
    program = build()
    compiler = compiler_of(program)
    reference = json.loads(REFERENCE.read_text())
    counts = {case: round(count(program, settings), 1)
              for case, settings in CASES.items()}
    print(f"Instructions per point and step, {compiler}: {counts}")
    if os.environ.get("MPM_RENEW"):
        reference[compiler] = counts
        REFERENCE.write_text(json.dumps(reference, indent=2) + "\n")
        return
    if compiler not in reference:
        print(f"Not compared: {REFERENCE.name} has no numbers for {compiler}.")
        return
    checks = Checks()
    for case, number in counts.items():
        before = reference[compiler][case]
        checks.that(number <= (1. + ALLOWED_GROWTH) * before,
                    f"{case}: instructions per point and step",
                    f"{number}, more than {100 * ALLOWED_GROWTH:.0f} % above "
                    f"{before} of {REFERENCE.name}. If the step has to do "
                    "more, renew the file (see the head of this test).")
    checks.exit()


main()
