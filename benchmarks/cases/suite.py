"""What the cases share: runs, checks, and the page they are written to."""

import dataclasses
import math

import numpy
from plotting.convergence import new_figure, save_small
from studies.program import ROOT
from studies.tables import markdown, number


@dataclasses.dataclass
class Check:
    """A measured number and the band it must lie in."""
    what: str
    value: float
    least: float
    most: float

    @property
    def holds(self):
        return self.least <= self.value <= self.most  # false for nan

    @property
    def band(self):
        if self.least == -math.inf:
            return f"≤ {number(self.most)}"
        if self.most == math.inf:
            return f"≥ {number(self.least)}"
        return f"{number(self.least, 4)} to {number(self.most, 4)}"


class Suite:
    """Runs the program for the cases and collects their page.

    subject: the folder of prm/ with their inputs; quick: cases run their smallest
    form, without pictures.
    """

    def __init__(self, program, subject, pictures, quick):
        self.program = program
        self.subject = subject
        self.pictures = pictures
        self.quick = quick
        self.lines, self.checks, self.inputs = [], [], []
        self.summary = []  # of each section: title, checks, checks that hold
        self.title, self.n_checks_before = "", 0

    def input_file(self, case):
        """prm/SUBJECT/CASE.prm."""
        return ROOT / "prm" / self.subject / f"{case}.prm"

    def run(self, case, name, settings=None):
        """The run `name` of the input of a case."""
        if case not in self.inputs:
            self.inputs.append(case)
        return self.program.run(self.input_file(case), f"{case}/{name}",
                                settings)

    def begin(self, title):
        """Begins the section of a case."""
        self.title = title
        self.lines += [f"\n## {title}\n"]
        self.inputs = []
        self.n_checks_before = len(self.checks)

    def end(self):
        """The checks of the section, and its inputs."""
        checks = self.checks[self.n_checks_before:]
        self.summary.append([self.title, len(checks),
                             sum(check.holds for check in checks)])
        rows = [[check.what, number(check.value), check.band,
                 "yes" if check.holds else "**no**"] for check in checks]
        if rows:
            self.lines += [markdown(["checked", "measured", "allowed", "holds"],
                                    rows)]
        files = [f"[{name}.prm](../../prm/{self.subject}/{name}.prm)"
                 for name in self.inputs]
        self.lines += [f"Inputs: {', '.join(files)}.\n"]

    def text(self, text):
        """A paragraph."""
        self.lines += ["\n".join(line.strip() for line in
                                 text.strip().splitlines()) + "\n"]

    def table(self, header, rows, digits=3):
        self.lines += [markdown(header, rows, digits)]

    def check(self, what, value, least=-math.inf, most=math.inf):
        """Asserts a band of a measured number."""
        self.checks.append(Check(what, float(value), least, most))

    def figure(self, name, caption, draw, n_panels=1):
        """A picture; draw(panels) fills its panels."""
        if self.quick:
            return
        figure, panels = new_figure(n_panels)
        draw(*panels)
        save_small(figure, self.pictures / f"{name}.png")
        self.lines += [f"![{caption}]({name}.png)\n"]


def boxes(*numbers):
    """Numbers as the parameter file lists them."""
    return ", ".join(repr(value) for value in numbers)


def by_id(points):
    """The order that sorts points by their id."""
    return numpy.argsort(points["id"])


def matched(run, frame):
    """Initial positions, and the fields of a frame in the same order."""
    start, now = run.points(0), run.points(frame)
    order = by_id(now)
    fields = {name: values[order] for name, values in now.items()}
    return start["position"][by_id(start)].astype(float), fields
