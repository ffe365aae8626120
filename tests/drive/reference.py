#!/usr/bin/env python3
"""doc/drive.md has every entry and every test, and every column; a curve can be
drawn; mistakes are refused as those of a run are."""

import csv
import pathlib
import re
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "scripts"))
from _program import INPUTS, SOURCE_DIR, Checks, Folder  # noqa: E402

checks = Checks()
CASE = INPUTS / "drive" / "triaxial.prm"
page = (SOURCE_DIR / "doc" / "drive.md").read_text(encoding="utf8")

with Folder() as folder:
    printed = folder.run("--drive", "--print-parameters=markdown").stdout
section = printed.split("\n## Drive\n")[1].split("\n## ")[0]
entries = re.findall(r"^\| ([A-Z][a-z ]+) \| (?:`([^`]*)`)?", section, re.M)[1:]
checks.that(len(entries) >= 6, "entries are found", section)
for name, _ in entries:
    checks.that(f"| `{name}` |" in page, f"doc/drive.md has {name}")
tests = re.findall(r"'([a-z ]+)':", section)
checks.that(len(tests) >= 9, "tests are found", section)
for name in tests:
    checks.that(f"`{name}`" in page, f"doc/drive.md has the test {name}")

with Folder() as folder:
    done = folder.run("--drive", CASE, "--output", "out", "--set",
                      "Drive/Steps=60")
    checks.that(done.returncode == 0 and not done.stderr, "runs", str(done))
    checks.that(set(folder.files()) == {
        "out", *(f"out/{name}" for name in ("parameters.prm", "drive.csv",
                                            "yield.csv"))},
        "files", folder.files())
    with open(folder.path / "out/drive.csv", encoding="utf8") as file:
        rows = list(csv.DictReader(file))
    checks.that(len(rows) == 61, "rows", len(rows))
    for column in rows[0]:
        kind = re.sub(r"_([xyz])\1?.*", "", column)
        checks.that(f"`{column}`" in page or f"`{kind}_xx`" in page,
                    f"doc/drive.md has the column {column}")

    again = folder.run("--drive", CASE, "--output", "out")
    checks.that(again.returncode == 1 and "not empty" in again.stderr,
                "a folder that is not empty", str(again))
    again = folder.run("--drive", "out/parameters.prm", "--output", "out",
                       "--overwrite")
    checks.that(again.returncode == 0, "its own parameters, --overwrite",
                str(again))
    picture = subprocess.run(
        [sys.executable, SOURCE_DIR / "scripts" / "plot_drive.py", "out"],
        cwd=folder.path, capture_output=True, text=True, check=False)
    checks.that(picture.returncode == 0 and folder.files().get(
        "out/pictures/drive.png", 0) > 10000, "a picture", str(picture))

for settings, message in (
        ("Drive/Test=creep", "'creep'"),
        ("Drive/Strain=0.1, 0.1", "Drive/Strain"),
        ("Drive/Material=clay", "Drive/Material = clay"),
        ("Drive/Steps=2", "Drive/Steps"),
        ("Drive/Initial stress=-1", "Initial stress"),
        ("Materials/sand/Dilatancy angle=36", "'Dilatancy angle'")):
    with Folder() as folder:
        result = folder.run("--drive", CASE, "--set", settings)
        checks.that(result.returncode == 1 and message in result.stderr
                    and not folder.files(), settings, str(result))
for arguments, message in ((["--drive"], "parameter file"),
                           (["--drive", "--resume", "out"], "--resume"),
                           (["--drive", INPUTS / "wall_2d.prm"], "'Mesh'"),
                           ([CASE], "'Drive'")):
    with Folder() as folder:
        result = folder.run(*arguments)
        checks.that(result.returncode == 1 and message in result.stderr,
                    str(arguments), str(result))
checks.exit()
