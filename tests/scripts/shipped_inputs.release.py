#!/usr/bin/env python3
"""Every shipped parameter file can be run: its entries exist, its values are
allowed, mesh and points can be made. Tests of a material point (prm/drive) are
tried as such.

Usage: shipped_inputs.py [PROGRAM]
"""

from _program import Checks, Folder, shipped_inputs

checks = Checks()
for file in shipped_inputs():
    with Folder() as folder:
        kind = ["--drive"] if file.parent.name == "drive" else []
        result = folder.run("--check", *kind, file)
        checks.that(result.returncode == 0 and not result.stderr,
                    f"--check {file.name}", str(result))
        checks.that(not folder.files(), f"--check {file.name} writes files",
                    folder.files())
checks.exit()
