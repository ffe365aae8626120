"""A study: one input over sizes and variants, and what is observed."""

import dataclasses
import itertools
import pathlib
import tomllib

import numpy
from numpy.lib.recfunctions import append_fields

from .orders import estimate, observed_orders
from .tables import markdown, number, write_csv

FORMULA_NAMES = {name: getattr(numpy, name) for name in (
    "pi", "sin", "cos", "tan", "exp", "log", "sqrt", "sinh", "cosh", "tanh",
    "arctan", "minimum", "maximum")} | {"abs": numpy.abs}


class StudyError(Exception):
    """A study file that cannot be used."""


@dataclasses.dataclass
class Level:
    size: float     # for orders, usually the size of the cells
    settings: dict


@dataclasses.dataclass
class Variant:
    label: str
    settings: dict


@dataclasses.dataclass
class Observable:
    """A number taken from the table of observables of a run."""
    name: str
    value: str         # formula of the columns, say "kinetic_energy/mass"
    unit: str = ""
    at: float = None   # time [s]; the last row if None
    norm: str = "last"
    exact: str = ""    # formula of the time t; none: orders from three levels

    def series(self, table, constants):
        """What is observed, over time."""
        columns = {name: table[name] for name in table.dtype.names}
        return formula(self.value, columns | constants)

    def error(self, table, constants):
        """The deviation from the exact formula, over time."""
        exact = formula(self.exact, constants | {"t": table["time"]})
        return numpy.abs(self.series(table, constants) - exact)

    def reduce(self, series, table):
        """One number of a series over time: its mean square's root, its
        largest magnitude, or its value at the time."""
        if self.norm == "rms":
            return float(numpy.sqrt(numpy.mean(series**2)))
        if self.norm == "max":
            return float(numpy.abs(series).max())
        row = (-1 if self.at is None else
               int(numpy.argmin(numpy.abs(table["time"] - self.at))))
        return float(series[row])


def formula(text, names):
    """The value of a formula in Python's notation with functions of numpy."""
    try:
        return eval(text, {"__builtins__": {}}, FORMULA_NAMES | names)
    except (NameError, SyntaxError, TypeError) as error:
        known = ", ".join(sorted(names))
        raise StudyError(f"the formula '{text}' cannot be computed: {error}. "
                         f"Names beside functions: {known}") from error


class Study:
    """A study file; doc/studies.md describes it."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        try:
            with open(self.path, "rb") as file:
                content = tomllib.load(file)
        except OSError as error:
            raise StudyError(f"'{path}' cannot be read: {error}") from error
        except tomllib.TOMLDecodeError as error:
            raise StudyError(f"'{path}' is not TOML: {error}") from error
        try:
            self.title = content.pop("title", self.path.stem)
            self.input = (self.path.parent / content.pop("input")).resolve()
            self.size_label = content.pop("size label", "size of cells h [m]")
            self.settings = content.pop("settings", {})
            self.constants = content.pop("constants", {})
            self.levels = [Level(level.pop("size"), level.pop("settings", {}))
                           for level in content.pop("levels")]
            self.variants = combinations(content.pop("vary", []))
            self.observables = [Observable(**entry)
                                for entry in content.pop("observables")]
        except KeyError as error:
            raise StudyError(f"'{path}' lacks {error}") from error
        except TypeError as error:
            raise StudyError(f"'{path}': {error}") from error
        if content:
            raise StudyError(f"'{path}' has unknown entries: "
                             f"{', '.join(sorted(content))}")
        for observable in self.observables:
            if observable.norm not in ("last", "max", "rms"):
                raise StudyError(
                    f"'{path}': norm of '{observable.name}' must be one of "
                    f"last, max, rms; given: '{observable.norm}'")
        self.levels.sort(key=lambda level: -level.size)
        self.name = self.path.stem

    def run(self, program):
        """All runs: {variant's label: [table of each level]}."""
        tables = {}
        for number_of, variant in enumerate(self.variants):
            tables[variant.label] = []
            for level in self.levels:
                run = program.run(
                    self.input, f"variant_{number_of}_size_{level.size:g}",
                    self.settings | variant.settings | level.settings)
                tables[variant.label].append(with_cost(run))
        return tables

    def results(self, tables):
        """For each observable, what its table and its plot need."""
        return [Result(self, observable, tables)
                for observable in self.observables]


class Result:
    """An observable over all levels and variants."""

    def __init__(self, study, observable, tables):
        self.observable = observable
        self.sizes = [level.size for level in study.levels]
        self.values, self.errors, self.orders, self.estimates = {}, {}, {}, {}
        for label, levels in tables.items():
            values = [observable.reduce(
                observable.series(table, study.constants), table)
                for table in levels]
            self.values[label] = values
            self.estimates[label] = estimate(self.sizes, values)
            if observable.exact:
                self.errors[label] = [observable.reduce(
                    observable.error(table, study.constants), table)
                    for table in levels]
                self.orders[label] = observed_orders(self.sizes,
                                                     self.errors[label])

    def rows(self):
        """[variant, size, value, error, order] for each run; the order is that
        from the level before to this one."""
        rows = []
        for label, values in self.values.items():
            errors = self.errors.get(label, [numpy.nan] * len(values))
            orders = [numpy.nan] + list(self.orders.get(
                label, [numpy.nan] * (len(values) - 1)))
            rows += [[label, *row] for row in
                     zip(self.sizes, values, errors, orders)]
        return rows

    def markdown(self):
        """Table and estimate as a piece of a document."""
        name, unit = self.observable.name, self.observable.unit
        title = f"{name} [{unit}]" if unit else name
        if self.observable.exact:
            text = markdown(["variant", "size", title, "error", "order"],
                            [[label, size, number(value, 6), error, order]
                             for label, size, value, error, order in
                             self.rows()])
        else:
            text = markdown(["variant", "size", title],
                            [[label, size, number(value, 6)]
                             for label, size, value, _, _ in self.rows()])
        lines = []
        for label, found in self.estimates.items():
            if self.observable.exact:
                continue
            if not found.is_credible:
                lines.append([label, found.order, "–", "–"])
            else:
                lines.append([label, found.order,
                              number(found.extrapolated, 6),
                              f"{100 * found.gci:.2g} %"])
        if lines:
            text += "\n" + markdown(
                ["variant", "observed order", "extrapolated to size 0",
                 "error bar of the finest (GCI)"], lines)
        return text


def with_cost(run):
    """The table of observables of a run, with a column `loop_seconds`: the wall
    time of all its steps, the same in every row."""
    seconds = run.manifest["performance"]["loop_seconds"]
    return append_fields(run.table, "loop_seconds",
                         numpy.full(len(run.table), seconds), usemask=False)


def combinations(varied):
    """All combinations of what is varied, as variants with labels."""
    axes = []
    for entry in varied:
        if "choices" in entry:
            axes.append([Variant(choice["label"], choice["settings"])
                         for choice in entry["choices"]])
        else:
            name = entry.get("name", entry["entry"].split("/")[-1])
            axes.append([Variant(f"{name} {value}", {entry["entry"]: value})
                         for value in entry["values"]])
    variants = []
    for parts in itertools.product(*axes):
        settings = {}
        for part in parts:
            settings |= part.settings
        variants.append(Variant(", ".join(part.label for part in parts) or
                                "all", settings))
    return variants


def write(study, results, folder, version):
    """study.md, study.csv and study.png in a folder."""
    rows = [[result.observable.name, *row]
            for result in results for row in result.rows()]
    write_csv(folder / "study.csv",
              ["observable", "variant", "size", "value", "error", "order"],
              rows)
    text = f"# {study.title}\n\n{study.input.name}, {version}.\n"
    for result in results:
        text += f"\n## {result.observable.name}\n\n{result.markdown()}"
    text += "\n![Over the size](study.png)\n"
    (folder / "study.md").write_text(text, encoding="utf8")
    draw(study, results, folder / "study.png")


def draw(study, results, path):
    """Errors where there is a formula, values where there is none."""
    from plotting.convergence import (draw_convergence, line_style, new_figure,
                                      save_small)
    figure, panels = new_figure(len(results))
    for axes, result in zip(panels, results):
        name, unit = result.observable.name, result.observable.unit
        if result.errors:
            draw_convergence(
                axes, {label: (result.sizes, errors)
                       for label, errors in result.errors.items()},
                orders=(1, 2), size_label=study.size_label,
                error_label=f"error of {name}" + (f" [{unit}]" if unit else ""))
        else:
            for index, (label, values) in enumerate(result.values.items()):
                axes.plot(result.sizes, values, label=label,
                          **line_style(index))
            axes.set_xlim(left=0.)
            axes.set_xlabel(study.size_label)
            axes.set_ylabel(name + (f" [{unit}]" if unit else ""))
            axes.grid(True, color="0.9", linewidth=.8)
            axes.legend(fontsize=9)
    save_small(figure, path)
