"""Runs the program for other tests, which import this file."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

PROGRAM = pathlib.Path(
    sys.argv[1] if len(sys.argv) > 1 else os.environ["MPM_PROGRAM"]).resolve()
SOURCE_DIR = pathlib.Path(
    os.environ.get("MPM_SOURCE_DIR",
                   pathlib.Path(__file__).resolve().parents[2]))
INPUTS = SOURCE_DIR / "prm"
TIME_LIMIT = 900  # seconds; Debug builds on busy machines are slow


def shipped_inputs():
    """The parameter files that are shipped; there is at least one."""
    files = sorted(INPUTS.rglob("*.prm"))
    assert files, f"no inputs in {INPUTS}"
    return files


class Checks:
    """Counts what is as it should be, and tells what is not."""

    def __init__(self):
        self.n_done = 0
        self.n_failed = 0

    def that(self, condition, name, explanation=""):
        """Records whether the condition of this name holds."""
        self.n_done += 1
        if not condition:
            self.n_failed += 1
            print(f"FAILED: {name}\n{explanation}\n", flush=True)

    def exit(self):
        """Ends the test."""
        print(f"{self.n_done} checks, {self.n_failed} failed")
        sys.exit(1 if self.n_failed or not self.n_done else 0)


class Folder:
    """A folder of its own for each run, empty at its start."""

    def __enter__(self):
        self.path = pathlib.Path(tempfile.mkdtemp(prefix="mpm_test_"))
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.path)

    def files(self):
        """All files and folders in it, with the sizes of the files."""
        return {str(p.relative_to(self.path)): p.stat().st_size if p.is_file()
                else None for p in self.path.rglob("*")}

    def run(self, *arguments, before=()):
        """Runs the program here; `before` is put in front, say, mpirun."""
        return subprocess.run(
            [str(word) for word in (*before, PROGRAM, *arguments)],
            cwd=self.path, capture_output=True, text=True, errors="replace",
            timeout=TIME_LIMIT, stdin=subprocess.DEVNULL, check=False)
