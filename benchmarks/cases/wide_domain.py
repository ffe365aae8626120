"""A body in a domain that is much wider than itself."""

from .adaptive import outcome, picture

TITLE = "A wide domain"


def adapt(suite):
    if suite.quick:
        coarse = {"Mesh/Subdivisions": "50, 1, 10", "End time": .01}
    else:
        coarse = {}
    suite.text("""
The wall stands in the middle of a domain 20 m wide. What making mesh and points takes, and the
largest memory of the process, less that of a run with some thousand cells and points, which is
nearly all libraries. (The uniform mesh is not run any further than a few steps here.)
""")
    adaptive = suite.run("wide_3d", "adaptive", coarse)
    few_steps = {"End time": .002, "Output/Write grid": False}
    start, fine = (
        outcome(suite.run("wide_3d", kind, coarse | few_steps | extra))
        for kind, extra in (("start", {}), ("fine", {
            "Adaptive mesh/Minimum level": 2})))
    libraries = outcome(suite.run("wall_2d_quadrilaterals", "few_steps",
                                  few_steps)).memory
    suite.table(["mesh", "cells", "set-up [s]", "memory [MB]",
                 "less libraries [MB]"],
                [[name, f"{run.cells:,}", run.set_up, run.memory,
                  run.memory - libraries]
                 for name, run in (("adaptive", start), ("fine", fine))])
    ends = outcome(adaptive)
    if not suite.quick:
        suite.check("set-up time on the fine mesh over that on the adaptive one",
                    fine.set_up / start.set_up, least=5.)
        suite.check("memory on the fine mesh over that on the adaptive one, less "
                    "libraries",
                    (fine.memory - libraries) / (start.memory - libraries),
                    least=5.)
        suite.check("front of the wall at 2 s [m]", ends.front, 3.2, 3.5)
        picture(suite, adaptive, "wide", "The mesh from the side")
    suite.check("largest closure of the ledger", abs(ends.closure), most=2e-3)
