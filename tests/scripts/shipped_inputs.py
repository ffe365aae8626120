#!/usr/bin/env python3
"""Every shipped parameter file can be run: its entries exist, its values are
allowed, mesh and points can be made.

Usage: shipped_inputs.py [PROGRAM]
"""

from _program import Checks, Folder, shipped_inputs

checks = Checks()
for file in shipped_inputs():
    with Folder() as folder:
        result = folder.run("--check", file)
        checks.that(result.returncode == 0 and not result.stderr,
                    f"--check {file.name}", str(result))
        checks.that(not folder.files(), f"--check {file.name} writes files",
                    folder.files())
checks.exit()
