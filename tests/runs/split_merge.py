"""Points that are split where the mesh becomes finer and merged where it becomes
coarser again: a flying block stays what it is, a collapse keeps its mass and its
balance of energy, and a run that is continued is the one that was not."""

from _case import ELASTIC, KINDS, Folder, body, boundaries, box, run
from _restart import (IS_DEBUG, Case, checks, column, interrupted, same,
                      uninterrupted)


def adaptive(level, interval, least, most):
    """The section Adaptive mesh with levels by place and time."""
    return f"""
subsection Adaptive mesh
  set Names                 = somewhere
  set Maximum level         = 1
  set Interval              = {interval}
  set Interval displacement = 0
  set Split points below    = {least}
  set Merge points above    = {most}
  subsection somewhere
    set Type  = region
    set Level = {level}
  end
end
"""


def flying_block(dim, kind, n_steps=60):
    """A block flies through a part of the mesh that is fine for a while."""
    sides = ["x_min", "x_max", "y_min", "y_max", "z_min", "z_max"][:2 * dim]
    end = n_steps * 1e-3
    return f"""
set Dimension = {dim}
set End time  = {end}
{box(dim, [0., 0., 0.], (1.2, .6, .6), (12, 6, 6), kind)}
{body(dim, [.1, .1, .1], (.4, .4, .4), 8 if dim == 3 else 4,
      material=ELASTIC.format(density=1000, young=1e3, poisson=.3))}
{boundaries(all=("free", sides))}
subsection Initial state
  set Velocity = {"; ".join(["0.8", "0.1", "0.1"][:dim])}
end
subsection Body force
  set Gravity = {", ".join(["0"] * dim)}
end
subsection Time step
  set Type       = fixed
  set Fixed step = 1e-3
end
""" + adaptive(f"if(x < 0.31 & t > {.3 * end} & t < {.7 * end}, 1, 0)",
               10, 4, 6)


for dim in (2,) if IS_DEBUG else (2, 3):
    for kind in KINDS:
        result = run(flying_block(dim, kind))
        name = f"flying block, {dim}D, {kind}"
        checks.that(result.exit_code == 0, name, result.text[-2000:])
        if result.exit_code != 0:
            continue
        n_points = result["points"]
        checks.that(max(n_points) > 1.3 * n_points[0], f"{name}: split",
                    str(n_points))
        checks.that(n_points[-1] < .8 * max(n_points), f"{name}: merged",
                    str(n_points))
        for quantity in ("mass", "kinetic_energy"):
            values = result[quantity]
            checks.that(max(values) - min(values) <= 1e-12 * values[0],
                        f"{name}: {quantity}", f"{values[0]} {values[-1]}")
        for quantity, speed in (("center_x", .8), ("center_y", .1)):
            way = result.last(quantity) - result[quantity][0]
            checks.that(abs(way - speed * result.last("time")) < 1e-12,
                        f"{name}: {quantity}", str(way))
        checks.that(max(result["elastic_energy"]) <
                    1e-20 * result["kinetic_energy"][0], f"{name}: no stress",
                    str(result.last("elastic_energy")))

# Sand that collapses on a mesh that becomes fine at its foot. All sand stays.
COLLAPSE = adaptive("if(x < 0.16 + 2*t & y < 0.2, 1, 0)", 20, 3, 6)
for kind in KINDS:
    text = column(2, kind, "0.08")  # before the first points leave the mesh
    plain, changed = run(text), run(text + COLLAPSE)
    name = f"collapse, {kind}"
    checks.that(changed.exit_code == 0, name, changed.text[-2000:])
    if changed.exit_code != 0:
        continue
    checks.that(changed.last("lost_points") == plain.last("lost_points") == 0.
                and abs(changed.last("mass") / plain.last("mass") - 1.) < 1e-12,
                f"{name}: mass", f"{changed.last('mass')}")
    checks.that(len(set(changed["points"])) > 2, f"{name}: split and merged",
                str(changed["points"]))

    # Merging alone, on the same mesh: what it takes is in the ledger. Without
    # that the balance would be off by the loss, more than 1e-2 of the energy.
    merged = run(text + adaptive("0", 20, 0, 3))
    checks.that(merged.exit_code == 0 and
                merged.last("points") < .9 * plain.last("points"),
                f"{name}: only merged", merged.text[-2000:])
    checks.that(merged.last("transfer_loss") - plain.last("transfer_loss") >
                1e-2 * plain["potential_energy"][0] and
                abs(merged.last("closure") - plain.last("closure")) < 1e-3,
                f"{name}: balance", f"{merged.last('transfer_loss')}, "
                f"{plain.last('transfer_loss')}, {merged.last('closure')}, "
                f"{plain.last('closure')}")

# Ids of halves go on where they were.
name = "continued"
reference = uninterrupted(column(2) + COLLAPSE)
with Folder() as folder:
    case = Case(folder, column(2) + COLLAPSE)
    code = interrupted(case)
    checks.that(code == 3, f"{name}: interrupted", str(code))
    case.run("--resume", "out")
    same(name, case.results(), reference)
checks.exit()
