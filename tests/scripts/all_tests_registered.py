#!/usr/bin/env python3
"""Every file in tests/ that is a test is registered with ctest, and no other.

deal.II's macros leave a test out silently when its reference output is missing,
when its name carries an unknown with_* tag, or when a limit is set. So the list
of tests is worked out here from the files alone and compared with ctest's.
"""

import json
import os
import pathlib
import re
import subprocess
import sys

source = pathlib.Path(os.environ["MPM_SOURCE_DIR"]) / "tests"
build = os.environ["MPM_BUILD_DIR"]
build_type = os.environ["MPM_BUILD_TYPE"].lower()

problems = []
expected = {"build_test_programs"}

for room in sorted(path for path in source.iterdir() if path.is_dir()):
    if room.name == "__pycache__":
        continue
    outputs = sorted(room.glob("*.output"))
    names = {path.name.split(".")[0] for path in outputs}

    for path in outputs:
        tags = path.name.split(".")[1:-1]
        if any(tag.startswith("with_") for tag in tags):
            problems.append(f"{path}: a with_* tag can skip a test silently")
        if {"debug", "release"} & set(tags) - {build_type}:
            continue
        ranks = "".join(f".{tag}" for tag in tags if re.match(r"mpirun=\d+$", tag))
        threads = "".join(f".{tag}" for tag in tags if re.match(r"threads=\d+$", tag))
        base = path.name.split(".")[0]
        if ranks and (room / f"{base}.output").exists():
            problems.append(f"{room / base}.output: name its ranks as well, mpirun=1")
        expected.add(f"{room.name}/{base}{ranks}{threads}.{build_type}")

    for path in sorted(path for path in room.iterdir() if path.is_file()):
        base, *tags = path.name.split(".")[:-1]
        if {"debug", "release"} & set(tags) - {build_type}:
            continue
        if path.suffix in (".py", ".sh") and not path.name.startswith("_"):
            expected.add(f"{room.name}/{base}.{build_type}")
        elif path.suffix == ".cc" and base not in names:
            problems.append(f"{path}: a test without its {base}.output")
        elif path.name.endswith((".prm", ".prm.in")) and base not in names:
            if not (room / f"{base}.py").exists():
                problems.append(f"{path}: neither {base}.output nor {base}.py is there")

listing = subprocess.run(
    [os.environ.get("MPM_CTEST", "ctest"), "--show-only=json-v1"],
    cwd=build, check=True, capture_output=True, text=True).stdout
registered = {test["name"] for test in json.loads(listing)["tests"]}
# deal.II 9.5 and later add tests of their own that build shared programs.
registered = {name for name in registered if not name.startswith("test_dependency/")}

problems += [f"{name}: not registered, run cmake again or see its CMakeLists.txt"
             for name in sorted(expected - registered)]
problems += [f"{name}: registered, but its file is gone, run cmake again"
             for name in sorted(registered - expected)]

print(f"{len(expected)} tests expected, {len(registered)} registered")
for problem in problems:
    print(problem)
sys.exit(1 if problems else 0)
