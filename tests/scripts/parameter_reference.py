#!/usr/bin/env python3
"""doc/parameters.md is what the program says of its parameters. After a change:

    ./mpm_granular --print-parameters=markdown > doc/parameters.md

Usage: parameter_reference.py [PROGRAM]
"""

import difflib

from _program import SOURCE_DIR, Checks, Folder

checks = Checks()
reference = SOURCE_DIR / "doc" / "parameters.md"
with Folder() as folder:
    printed = folder.run("--print-parameters=markdown").stdout
written = reference.read_text() if reference.exists() else ""
difference = "\n".join(difflib.unified_diff(
    written.splitlines(), printed.splitlines(), str(reference), "printed",
    lineterm=""))
checks.that(printed and printed == written, f"{reference} is up to date",
            __doc__ + difference)
checks.exit()
