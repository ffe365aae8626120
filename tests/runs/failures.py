"""What goes wrong on the way ends with exit code 2, one message that names point
and place, and a last output; or, if wanted, goes on without the point."""

import json

from _case import Checks, Folder, escaping_body

checks = Checks()

with Folder() as folder:
    (folder.path / "case.prm").write_text(escaping_body())
    process = folder.run("case.prm", "--output", "out")
    checks.that(process.returncode == 2, "a lost point: exit code 2",
                process.stderr)
    checks.that("has left the mesh" in process.stderr and
                "Point " in process.stderr and "time" in process.stderr and
                len(process.stderr.strip().splitlines()) == 1,
                "a lost point: one message", process.stderr)
    manifest = json.loads((folder.path / "out/manifest.json").read_text())
    checks.that(manifest["outcome"] == "failed", "a lost point: manifest",
                str(manifest))
    pieces = list(folder.path.glob("out/points/*.vtu"))
    checks.that(len(pieces) >= 2, "a lost point: a last output", str(pieces))

with Folder() as folder:
    (folder.path / "case.prm").write_text(escaping_body())
    process = folder.run("case.prm", "--output", "out", "--set",
                         "Points/Remove lost points=true", "--set",
                         "End time=0.3")
    last = (folder.path / "out/observables.csv").read_text().splitlines()
    row = dict(zip(last[0].split(","), map(float, last[-1].split(","))))
    checks.that(process.returncode == 0 and row["lost_points"] > 0 and
                row["lost_points"] + row["points"] == 128,
                "lost points are removed and counted",
                process.stderr + str(row))
checks.exit()
