"""The quick form of the verification suite: all its checks hold."""

import os
import pathlib
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(os.environ["MPM_SOURCE_DIR"])
with tempfile.TemporaryDirectory(prefix="mpm_test_") as folder:
    process = subprocess.run(
        [sys.executable, SOURCE / "benchmarks" / "verify", "--quick",
         "--runs", folder], stdin=subprocess.DEVNULL, check=False)
sys.exit(process.returncode)
