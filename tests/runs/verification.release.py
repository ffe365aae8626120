"""The quick forms of verification, validation and of what is measured of adaptive
meshes: all their checks hold."""

import os
import pathlib
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(os.environ["MPM_SOURCE_DIR"])
failed = 0
for command in ("verify", "validate", "adapt"):
    with tempfile.TemporaryDirectory(prefix="mpm_test_") as folder:
        process = subprocess.run(
            [sys.executable, SOURCE / "benchmarks" / command, "--quick",
             "--runs", folder], stdin=subprocess.DEVNULL, check=False)
    failed |= process.returncode
sys.exit(failed)
