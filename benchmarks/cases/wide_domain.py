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
largest memory of the process, to which libraries alone contribute some 150 MB. (The uniform
mesh is not run any further than a few steps here.)
""")
    adaptive = suite.run("wide_3d", "adaptive", coarse)
    few_steps = {"End time": .002, "Output/Write grid": False}
    start, fine = (
        outcome(suite.run("wide_3d", kind, coarse | few_steps | extra))
        for kind, extra in (("start", {}), ("fine", {
            "Adaptive mesh/Minimum level": 2})))
    suite.table(["mesh", "cells", "set-up [s]", "memory [MB]"],
                [["adaptive", f"{start.cells:,}", start.set_up, start.memory],
                 ["fine", f"{fine.cells:,}", fine.set_up, fine.memory]])
    ends = outcome(adaptive)
    if not suite.quick:
        suite.check("set-up time on the fine mesh over that on the adaptive one",
                    fine.set_up / start.set_up, least=5.)
        suite.check("memory on the fine mesh over that on the adaptive one",
                    fine.memory / start.memory, least=5.)
        suite.check("front of the wall at 2 s [m]", ends.front, 3.2, 3.5)
        picture(suite, adaptive, "wide", "The mesh from the side")
    suite.check("largest closure of the ledger", abs(ends.closure), most=2e-3)
