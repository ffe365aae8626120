"""A geostatic column stays at rest to round-off: with symmetric points linear
stresses are integrated exactly (physics: K0 = nu/(1 - nu) is elastic and inside
the cone). A lattice does not have this property; that it does not shows that the
test can fail."""

from _case import KINDS, Checks, body, box, points_per_cell, rollers, run

checks = Checks()


def column(dim, layout="", kind="simplices"):
    up = (1., 2.) if dim == 2 else (1., 1., 2.)
    cells = (5, 10) if dim == 2 else (3, 3, 6)
    return f"""
set Dimension = {dim}
set End time  = 0.2
{box(dim, [0., 0., 0.], up, cells, kind)}
{body(dim, [0., 0., 0.], up, points_per_cell(dim, kind))}
subsection Points
  subsection body
    {layout}
  end
end
{rollers(dim)}
subsection Initial state
  set Stress        = geostatic
  set Surface level = 2
  set K0            = 0.4285714285714286
end
"""


# The paper's method, and the settings that are recommended for flows.
RECOMMENDED = ["Scheme/Averaging=cells", "Scheme/Pressure filter rate=500"]

for dim in (2, 3):
    for kind in KINDS:
        for settings in ([], RECOMMENDED):
            result = run(column(dim, kind=kind), *settings)
            name = f"{dim}D, {kind}, {settings}"
            scale = result["potential_energy"][0]
            checks.that(result.exit_code == 0 and
                        max(result["kinetic_energy"]) < 1e-24 * scale,
                        f"{name}: at rest",
                        result.text + str(max(result["kinetic_energy"]) / scale))
            checks.that(result["time"][-1] == 0.2, f"{name}: ends at the end time")

spacing = column(2).replace("set Points per cell = 4",
                            "set Layout = lattice\nset Spacing = 0.1, 0.1")
result = run(spacing)
checks.that(max(result["kinetic_energy"]) >
            1e-12 * result["potential_energy"][0], "a lattice is not at rest",
            result.text)
checks.exit()
