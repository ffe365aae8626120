"""A run that is killed at twenty random moments, and continued each time, leaves
the same files, bit for bit, as one that was not, in every format. After each kill
everything that records name is complete, and the newest checkpoint is used."""

from _case import Folder
from _fields import read_series
from _restart import (IS_DEBUG, SEED, Case, checks, column, kill, same,
                      uninterrupted)

FORMATS = {"VTU": 7, "PVTU": 7, "HDF5": 6}  # and the number of kills


def look(case, n_kills):
    """What there is after a kill."""
    name = f"{len(n_kills)} kills, seed {SEED}"
    n_kills.append(None)
    try:
        for series in ("points", "grid"):
            if any((case.path / f"{series}.{record}").exists()
                   for record in ("pvd", "xdmf")):
                instants = read_series(case.path, series)
                checks.that(all(len(fields["position"]) > 0
                                for _, fields in instants),
                            f"{name}: {series} of {len(instants)} instants")
        if case.begin():
            case.manifest()
        table = case.path / "observables.csv"
        if table.exists():
            rows = table.read_text()
            checks.that(rows.endswith("\n") and
                        len({row.count(",") for row in rows.split()}) == 1,
                        f"{name}: observables.csv", rows[-1000:])
    except (AssertionError, OSError, ValueError) as error:
        checks.that(False, f"{name}: can be read", f"{type(error)} {error}")


print(f"seed {SEED}")
for form, n_times in FORMATS.items():
    settings = (f"Output/Format={form}", "Output/Interval=0.003")
    reference = uninterrupted(column(2), settings)
    with Folder() as folder:
        case = Case(folder, column(2), settings)
        n_times = 1 if IS_DEBUG else n_times
        n_looks = []
        arguments, n_killed = kill(case, n_times, lambda: look(case, n_looks))
        checks.that(n_killed == n_times, f"{form}: killed", str(n_killed))
        case.run(*arguments)
        log = (case.path / "log.txt").read_text()
        checks.that("cannot be used" not in log, f"{form}: checkpoints", log)
        same(form, case.results(), reference)
        print(f"{form}: {n_killed} kills, the last run resumed "
              f"{len(case.manifest()['resumed'])} times")
checks.exit()
