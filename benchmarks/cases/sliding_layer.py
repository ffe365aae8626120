"""A mesh that is fine where the sand shears, with splitting and merging."""

from .adaptive import outcome, picture

TITLE = "The layer that slides"


def adapt(suite):
    settings = {"End time": .2} if suite.quick else {}
    suite.text("""
Criteria `shear` and `free surface`: cells of 0.05 m where the velocity jumps by more than 0.3 m/s
across a cell, and at the surface; 0.1 m elsewhere, also in the sand. Points are split where
cells have fewer than 3, and merged where they have more than 24.
""")
    runs = {
        "fine where it shears": suite.run("shear_band_2d", "adaptive", settings),
        "0.05 m everywhere": suite.run("shear_band_2d", "fine", settings | {
            "Adaptive mesh/Minimum level": 1,
            "Points/wall/Points per cell": 4}),
        "0.1 m everywhere": suite.run("shear_band_2d", "coarse", settings | {
            "Adaptive mesh/Names": ""})}
    rows = []
    for name, run in runs.items():
        end = outcome(run)
        rows.append([name, end.front, end.height, end.closure, f"{end.cells:,}",
                     int(run.table[-1]["points"]),
                     run.manifest["performance"]["loop_seconds"]])
    suite.table(["mesh", "front [m]", "height [m]", "closure", "cells", "points",
                 "time [s]"], rows, 4)
    adaptive, fine = (outcome(run) for run in list(runs.values())[:2])
    suite.check("front over that on the fine mesh", adaptive.front / fine.front,
                .97, 1.03)
    suite.check("height over that on the fine mesh",
                adaptive.height / fine.height, .96, 1.04)
    suite.check("closure of the ledger", abs(adaptive.closure), most=2e-3)
    picture(suite, runs["fine where it shears"], "sliding_layer",
            "The mesh at four instants, with the points")
