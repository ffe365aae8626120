#!/usr/bin/env python3
"""Which room may include which: the include directives against the table."""

import os
import pathlib
import re
import sys

# room -> rooms it may include, besides itself and those of EVERYWHERE.
EVERYWHERE = {"core", "parameters"}
ALLOWED = {
    "core": set(),
    "parameters": set(),
    "mesh": set(),
    "points": {"mesh"},
    "grid": {"mesh"},
    "materials": {"points"},
    "transfer": {"points", "grid", "mesh"},
    "momentum": {"grid", "mesh"},
    "boundary": {"grid", "mesh"},
    "adaptivity": {"grid", "mesh"},
    "time": {"mesh"},
    "checkpoint": set(),
    "output": {"points", "mesh", "materials"},
    "drive": {"points", "materials", "output"},
    "observables": {"points", "mesh", "materials"},
    "solver": {"mesh", "points", "grid", "materials", "transfer", "momentum",
               "boundary", "adaptivity", "time", "output", "observables",
               "checkpoint"},
}
# core is the lowest room; parameters may use it, not the other way round.
NOT_EVERYWHERE = {"core": {"parameters"}}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]mpm_granular/(\w+)/')


def forbidden_includes(path, room):
    """Lines of the file that include a room they may not."""
    allowed = ALLOWED[room] | EVERYWHERE | {room}
    allowed -= NOT_EVERYWHERE.get(room, set())
    for number, line in enumerate(path.read_text().splitlines(), 1):
        match = INCLUDE.match(line)
        if match and match[1] not in allowed:
            yield f"{path}:{number}: {room} may not include {match[1]}"


root = pathlib.Path(os.environ["MPM_SOURCE_DIR"])
n_files = 0
problems = []
for folder in (root / "include" / "mpm_granular", root / "source"):
    for path in sorted(folder.rglob("*")):
        if path.suffix not in (".h", ".cc"):
            continue
        room = path.relative_to(folder).parts[0]
        if room == "main.cc":
            continue
        n_files += 1
        if room not in ALLOWED:
            problems.append(f"{path}: the room {room} is not in the table")
        else:
            problems += forbidden_includes(path, room)

if n_files == 0:
    problems.append(f"no source files found in {root}")
print(f"{n_files} files, {len(problems)} problems")
for problem in problems:
    print(problem)
sys.exit(1 if problems else 0)
