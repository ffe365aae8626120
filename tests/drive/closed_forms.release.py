#!/usr/bin/env python3
"""Tests of one material point against closed forms: strength and dilation in
triaxial and plane strain compression, the mu(I) line in shear, the stiffness of
the oedometer.

Stresses are positive in compression here, angles in degrees. The formulas are
those of doc/drive.md, section 3.
"""

import csv
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "scripts"))
from _program import Checks, Folder  # noqa: E402

checks = Checks()
yield_line = []  # of the last test: pairs of p and q
VISCOPLASTIC = ["Fluidity=0.05", "Perzyna exponent=2"]
RELATIVE_RATE = .02  # axial rate of the tests over that fluidity
LATERAL = 1e5  # Pa
YOUNG, POISSON = 1e9, .3
BULK, SHEAR = YOUNG / (3 * (1 - 2 * POISSON)), YOUNG / (2 * (1 + POISSON))


def drive(law, test, *settings, strain=2e-3, rate=1e-3, steps=200,
          stress=LATERAL, exit_code=0):
    """Rows of drive.csv as dictionaries."""
    entries = {"Law": law, "Density": 1500, "Young modulus": YOUNG,
               "Poisson ratio": POISSON}
    entries.update(setting.split("=") for setting in settings)
    material = "\n".join(f"set {name} = {value}"
                         for name, value in entries.items())
    text = f"""
subsection Materials
  set Names = soil
  subsection soil
{material}
  end
end
subsection Drive
  set Test           = {test}
  set Initial stress = {-stress}, {-stress}, {-stress}
  set Strain rate    = {rate}
  set Strain         = {strain}
  set Steps          = {steps}
end
"""
    with Folder() as folder:
        (folder.path / "case.prm").write_text(text, encoding="utf8")
        result = folder.run("--drive", "case.prm", "--output", "out")
        checks.that(result.returncode == exit_code, f"{law}, {test}: runs",
                    str(result))
        if result.returncode:
            checks.that("out/drive.csv" in folder.files(),
                        f"{law}, {test}: what there is, is written")
            return result.stderr
        with open(folder.path / "out/yield.csv", encoding="utf8") as file:
            yield_line[:] = [(float(row["p"]), float(row["q"]))
                             for row in csv.DictReader(file)]
        with open(folder.path / "out/drive.csv", encoding="utf8") as file:
            return [{name: float(value) for name, value in row.items()}
                    for row in csv.DictReader(file)]


def slope(rows, column, over):
    """The slope at the end."""
    return ((rows[-1][column] - rows[-40][column])
            / (rows[-1][over] - rows[-40][over]))


def agree(name, value, expected, tolerance):
    checks.that(abs(value - expected) <= tolerance * max(abs(expected), .1),
                name, f"{value} instead of {expected}")


def agree_yield(name, strength, lowest):
    """The yield line is that of the function strength(p), from the pressure
    `lowest` on; flow that is too slow is not seen, hence the tolerance."""
    checks.that(len(yield_line) > 50
                and all(abs(q - strength(p)) <= 1e-6 * strength(p) + 1e-3
                        for p, q in yield_line), f"{name}: yield line",
                str(yield_line[:3]))
    # The line starts within a step of its pressures, or where the pressures do.
    step = yield_line[1][0] - yield_line[0][0]
    start = max(lowest, -.25 / 1.05 * yield_line[-1][0])
    checks.that(start - 1e-6 <= yield_line[0][0] < start + step,
                f"{name}: start of the yield line",
                f"{yield_line[0][0]}, not {start}")


def cone_slope(rule, degrees):
    s = math.sin(math.radians(degrees))
    return {"paper": 18 * s / (9 - s * s),
            "triaxial compression": 6 * s / (3 - s),
            "triaxial extension": 6 * s / (3 + s),
            "plane strain": math.sqrt(3) * s}[rule]


def drucker_prager(phi, cohesion, psi, rule, has_rate):
    """Strength and dilation, rate-independent and, if that is asked for,
    viscoplastic."""
    m, beta = cone_slope(rule, phi), cone_slope(rule, psi)
    apex = cohesion / math.tan(math.radians(phi))
    material = [f"Friction angle={phi}", f"Cohesion={cohesion}",
                f"Dilatancy angle={psi}", f"Cone slope={rule}"]
    name = f"Drucker-Prager, {rule}, {phi}, {cohesion}, {psi}"

    flows = [(["Flow=rate-independent"], 0.)]
    if has_rate:
        flows.append((VISCOPLASTIC, (RELATIVE_RATE / (1 - beta / 3))**.5))
    for flow, over in flows:
        rows = drive("Drucker-Prager cohesive", "triaxial compression",
                     *material, *flow)
        what = f"{name}, {flow[-1]}"
        factor = m * (1 + over)
        agree(f"{what}: q", rows[-1]["q"],
              3 * factor * (LATERAL + apex) / (3 - factor), 2e-5)
        agree(f"{what}: lateral stress", -rows[-1]["stress_xx"], LATERAL, 1e-9)
        # Volume over axial strain, both of flow alone; the steps are finite.
        agree(f"{what}: dilation", slope(rows, "volumetric_strain", "strain"),
              beta / (1 - beta / 3), 1e-4)

    agree_yield(name, lambda p: m * (p + apex), 0.)
    rows = drive("Drucker-Prager cohesive", "plane strain compression",
                 *material, "Flow=rate-independent", strain=.04, steps=2000)
    # No flow along y: s_y = -2 q beta/9, hence half the difference and the mean
    # of the stresses in the plane are q times
    half, mean = math.sqrt(1 / 3 - beta**2 / 27), 1 / m - beta / 9
    q = (LATERAL + apex) / (mean - half)
    agree(f"{name}: plane strain, q", rows[-1]["q"], q, 1e-4)
    agree(f"{name}: plane strain, stress", -rows[-1]["stress_zz"],
          LATERAL + 2 * q * half, 1e-4)


def mohr_coulomb(phi, cohesion, psi, has_rate):
    """The same; compression and extension are on opposite edges."""
    s, s_psi = (math.sin(math.radians(angle)) for angle in (phi, psi))
    term = 2 * cohesion * math.cos(math.radians(phi))
    apex = cohesion / math.tan(math.radians(phi))
    material = [f"Friction angle={phi}", f"Cohesion={cohesion}",
                f"Dilatancy angle={psi}", f"Tensile strength={cohesion / 2}"]
    name = f"Mohr-Coulomb, {phi}, {cohesion}, {psi}"
    flows = [["Flow=rate-independent"]] + [VISCOPLASTIC] * has_rate
    for flow in flows:
        what = f"{name}, {flow[-1]}"
        for test, rate in (("triaxial compression", 1 - s_psi),
                           ("plane strain compression", 1 - s_psi),
                           ("triaxial extension", 1 + s_psi)):
            x = (RELATIVE_RATE / rate)**.5 if flow is VISCOPLASTIC else 0.
            factor, excess = (1 + x) * s, (1 + x) * term
            if test == "triaxial extension":
                expected = (LATERAL * (1 - factor) - excess) / (1 + factor)
            else:
                expected = (LATERAL * (1 + factor) + excess) / (1 - factor)
            rows = drive("Mohr-Coulomb", test, *material, *flow)
            agree(f"{what}, {test}: stress", -rows[-1]["stress_zz"], expected,
                  2e-5)
            agree(f"{what}, {test}: dilation",
                  slope(rows, "volumetric_strain", "strain"), 2 * s_psi / rate,
                  1e-4)
            checks.that(rows[-1]["dissipated_energy"] > 0.
                        and all(after["dissipated_energy"]
                                >= before["dissipated_energy"] - 1e-6
                                for before, after in zip(rows, rows[1:])),
                        f"{what}, {test}: dissipates")
            # The largest stress, -p + q/3, is at most the tensile strength.
            if flow is not VISCOPLASTIC and test == "triaxial compression":
                agree_yield(f"{name}, {test}", lambda p: min(
                    6 * s / (3 - s) * (p + apex), 3 * (p + cohesion / 2)),
                    -cohesion / 2)


def mu_of_i():
    """Steady shear at constant volume: tau = mu(I) p."""
    mu_s, mu_2, i_0, diameter, density, p = .38, .64, .279, 1e-3, 2500., 1e4
    for rate in (.1, 100., 2000.):
        rows = drive("mu(I)", "constant volume shear",
                     f"Static friction={mu_s}", f"Largest friction={mu_2}",
                     f"Inertial number={i_0}", f"Grain diameter={diameter}",
                     f"Grain density={density}", rate=rate, stress=p,
                     strain=1e-3)
        number = rate * diameter * math.sqrt(density / p)
        friction = mu_s + (mu_2 - mu_s) / (i_0 / number + 1)
        agree(f"mu(I) at {rate}/s: q", rows[-1]["q"],
              math.sqrt(3) * friction * p, 1e-8)
        agree(f"mu(I) at {rate}/s: p", rows[-1]["p"], p, 1e-9)
    agree_yield("mu(I)", lambda p: math.sqrt(3) * mu_s * p, 0.)


def elasticity():
    """The stiffness of the oedometer and of isotropic compression."""
    rows = drive("linear elastic", "oedometer", strain=1e-5, steps=10)
    agree("oedometer", (rows[-1]["stress_zz"] + LATERAL) / rows[-1]["strain"],
          -(BULK + 4 / 3 * SHEAR), 1e-5)
    rows = drive("Mohr-Coulomb", "isotropic compression", strain=1e-5, steps=10)
    agree("isotropic compression", (rows[-1]["p"] - LATERAL)
          / rows[-1]["strain"], 3 * BULK, 1e-5)


def undrained():
    """At constant volume dilation makes the pressure grow along the cone."""
    m = cone_slope("paper", 30)
    rows = drive("Drucker-Prager cohesive", "undrained triaxial compression",
                 "Friction angle=30", "Dilatancy angle=10",
                 "Flow=rate-independent")
    agree("undrained: volume", math.exp(rows[-1]["volumetric_strain"]), 1.,
          1e-12)
    agree("undrained: on the cone", rows[-1]["q"], m * rows[-1]["p"], 1e-9)
    # Of p' = K beta l' and q' = 3 G (e' - l') on q = m p, with e' the rate of
    # axial strain.
    beta = cone_slope("paper", 10)
    agree("undrained: pressure", slope(rows, "p", "strain"),
          BULK * beta * 3 * SHEAR / (3 * SHEAR + m * BULK * beta), 1e-3)


def turning_back():
    """Unloading is elastic, with Young's modulus at constant lateral stress."""
    rows = drive("Mohr-Coulomb", "triaxial compression",
                 "Flow=rate-independent", strain="1e-3, 9e-4, 1.5e-3")
    checks.that([row["strain"] for row in rows if row["strain"] in
                 (1e-3, 9e-4, 1.5e-3)] == [1e-3, 9e-4, 1.5e-3],
                "turns where it should")
    turn = next(index for index, row in enumerate(rows)
                if row["strain"] == 1e-3)
    agree("unloading", (rows[turn + 5]["stress_zz"] - rows[turn]["stress_zz"])
          / (rows[turn]["strain"] - rows[turn + 5]["strain"]), YOUNG, 1e-3)
    checks.that(abs(rows[-1]["time"] - 1.7) < 1e-9, "time",
                str(rows[-1]["time"]))


turning_back()
drucker_prager(30, 0., 0., "paper", has_rate=False)
drucker_prager(35, 2e4, 10, "triaxial compression", has_rate=True)
drucker_prager(25, 1e4, 25, "plane strain", has_rate=False)
mohr_coulomb(30, 0., 0., has_rate=False)
mohr_coulomb(35, 2e4, 10, has_rate=True)
mu_of_i()
elasticity()
undrained()
message = drive("Mohr-Coulomb", "triaxial compression", stress=-1e3,
                exit_code=2)
checks.that("keeps the stress xx" in message and "At the strain 0" in message,
            "tension that is not borne", message)
checks.exit()
