"""The collapsing wall on a mesh that follows it, of every kind of cell."""

from .adaptive import outcome, picture

TITLE = "The wall"

KINDS = {"wall_2d": "triangles", "wall_2d_quadrilaterals": "quadrilaterals",
         "wall_3d": "tetrahedra", "wall_3d_hexahedra": "hexahedra"}


def adapt(suite):
    settings = {"End time": .2} if suite.quick else {}
    suite.text("""
The cells are 0.05 m where the sand is and in some layers around it, up to 0.2 m elsewhere.
The uniform mesh is the same input with `--set "Adaptive mesh/Minimum level=2"`: all cells are
divided twice, in the same way. The points never leave the fine cells, so front and height
agree to round-off, or to what chaos makes of it.
""")
    rows = []
    for name, cells in list(KINDS.items())[:2 if suite.quick else None]:
        adaptive, fine = (
            outcome(suite.run(name, kind, settings | extra))
            for kind, extra in (("adaptive", {}), ("fine", {
                "Adaptive mesh/Minimum level": 2})))
        for kind, run in (("adaptive", adaptive), ("fine", fine)):
            rows.append([cells, kind, run.front, run.height, run.closure,
                         f"{run.cells:,}", run.speed, run.adaptations,
                         f"{100. * run.part:.1f} %"])
        suite.check(f"{cells}: front over that on the fine mesh",
                    adaptive.front / fine.front, .98, 1.02)
        suite.check(f"{cells}: height over that on the fine mesh",
                    adaptive.height / fine.height, .98, 1.02)
        suite.check(f"{cells}: closure of the ledger, less that on the fine "
                    "mesh", abs(adaptive.closure) - abs(fine.closure), most=1e-4)
        suite.check(f"{cells}: cells over those of the fine mesh",
                    adaptive.cells / fine.cells, most=.5)
        # What others do on the machine must not fail a quick test.
        suite.check(f"{cells}: point-steps/s over those on the fine mesh",
                    adaptive.speed / fine.speed,
                    least=.2 if suite.quick else .85)
    suite.table(["cells", "mesh", "front [m]", "height [m]", "closure", "cells at "
                 "the end", "million point-steps/s", "changes of the mesh",
                 "time for them"], rows, 4)
    if not suite.quick:
        picture(suite, suite.run("wall_2d", "adaptive"), "wall_2d",
                "The mesh of triangles at four instants, with the points")
        picture(suite, suite.run("wall_3d_hexahedra", "adaptive"), "hexahedra",
                "The mesh of hexahedra from the side")
