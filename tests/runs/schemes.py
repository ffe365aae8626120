"""Choices of the scheme that must agree: alpha = 0 is the lumped mass matrix to
round-off; half of the step, and other orders of the stress update, end in the
same deposit."""

from _case import INPUTS, IS_DEBUG, Checks, run

checks = Checks()
WALL = INPUTS / "wall_2d.prm"
SHORT = "End time=0.1" if IS_DEBUG else "End time=0.3"

lumped = run(WALL, SHORT, "Time step/CFL=0.3")
same = run(WALL, SHORT, "Time step/CFL=0.3",
           "Scheme/Mass matrix=near-consistent", "Scheme/Consistent part=0",
           "Scheme/Solver tolerance=1e-15")
for column in ("front", "kinetic_energy", "potential_energy"):
    a, b = lumped.last(column), same.last(column)
    # Round-off grows in a flow of grains: some digits of sixteen go in 0.3 s.
    checks.that(abs(a - b) < 1e-6 * abs(a), f"alpha = 0 is lumped: {column}",
                f"{a} and {b}\n{same.text[-2000:]}")

consistent = run(WALL, "End time=0.1", "Scheme/Mass matrix=near-consistent",
                 "Scheme/Consistent part=0.5", "Time step/CFL=0.6")
reference = run(WALL, "End time=0.1")
a, b = consistent.last("kinetic_energy"), reference.last("kinetic_energy")
checks.that(consistent.exit_code == 0 and abs(a - b) < .05 * b,
            "alpha = 0.5 falls like alpha = 0", f"{a} and {b}")

for order in ("USL", "USF"):
    other = run(WALL, SHORT, f"Scheme/Stress order={order}",
                "Time step/CFL=0.2")
    a, b = other.last("kinetic_energy"), lumped.last("kinetic_energy")
    checks.that(other.exit_code == 0 and abs(a - b) < .05 * b,
                f"{order} collapses like MUSL", f"{a} and {b}")
    other = run(WALL, SHORT, f"Scheme/Stress order={order}", "Time step/CFL=0.2",
                "Scheme/Velocity update=PIC")
    checks.that(other.exit_code == 0 and
                other.last("kinetic_energy") < lumped.last("kinetic_energy"),
                f"{order} with PIC runs, and is slower", other.text[-2000:])
checks.exit()
