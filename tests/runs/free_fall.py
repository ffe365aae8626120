"""An unconstrained block: mass and momentum to round-off, and the centre of mass
of symplectic Euler, x = x0 + v0 t + g t (t + dt)/2, in every scheme."""

from _case import DIMENSIONS, ELASTIC, Checks, body, boundaries, box, run

checks = Checks()
SIDES = ["x_min", "x_max", "y_min", "y_max", "z_min", "z_max"]


def block(dim):
    cells = (12, 12, 12)
    return f"""
set Dimension = {dim}
set End time  = 0.2
{box(dim, [0., 0., 0.], (1.2, 1.2, 1.2), cells)}
{body(dim, [.4, .6, .4], (.8, 1., .8),
      material=ELASTIC.format(density=1000, young=1e5, poisson=.3))}
{boundaries(all=("free", SIDES[:2 * dim]))}
subsection Initial state
  set Velocity = {"0.5; 0" if dim == 2 else "0.5; 0; 0.25"}
end
subsection Body force
  set Gravity = {"1, -9" if dim == 2 else "1, -9, 0"}
end
subsection Time step
  set Type       = fixed
  set Fixed step = 1e-3
end
"""


SCHEMES = [["Scheme/Stress order=MUSL"], ["Scheme/Stress order=USL"],
           ["Scheme/Stress order=USF"], ["Scheme/Velocity update=FLIP"],
           ["Scheme/Velocity update=PIC"],
           ["Scheme/Velocity update=APIC", "Scheme/Averaging=nodes"],
           ["Scheme/Averaging=moving least squares"],
           ["Scheme/Velocity update=XPIC", "Scheme/Order=3"],
           ["Scheme/Velocity update=FMPM", "Scheme/Stress order=USL"],
           ["Scheme/Mass matrix=near-consistent",
            "Scheme/Consistent part=0.5"]]
for dim in DIMENSIONS:
    for scheme in SCHEMES:
        result = run(block(dim), *scheme)
        name = f"{dim}D {' '.join(scheme)}"
        if result.exit_code != 0:
            checks.that(False, name, result.text)
            continue
        time, dt = 0.2, 1e-3
        start = (.6, .8, .6)
        speed = (.5, 0., .25 if dim == 3 else 0.)
        gravity = (1., -9., 0.)
        for d, axis in enumerate("xyz"[:dim]):
            expected = (start[d] + speed[d] * time +
                        gravity[d] * time * (time + dt) / 2)
            found = result.last(f"center_{axis}")
            checks.that(abs(found - expected) < 1e-10, f"{name}: centre {axis}",
                        f"{found} instead of {expected}")
        mass = result["mass"]
        checks.that(max(abs(m - mass[0]) for m in mass) < 1e-12 * mass[0],
                    f"{name}: mass")
        checks.that(result.last("lost_points") == 0, f"{name}: no point lost")
checks.exit()
