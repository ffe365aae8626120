"""Curves over time from observables.csv."""

import numpy

from .style import COLOURS, pyplot, save


def time_range(axes, table):
    """The time axis without empty margins."""
    if table["time"][-1] > table["time"][0]:
        axes.set_xlim(table["time"][0], table["time"][-1])


def energies(run):
    """Where the energy goes, and what of it is not accounted for."""
    table = run.table
    time = table["time"]
    initial = sum(table[name][0] for name in (
        "kinetic_energy", "elastic_energy", "potential_energy"))
    scale = table["potential_energy"][0] or initial or 1.
    unit = "J/m" if run.dimension == 2 else "J"

    figure, (upper, middle, lower) = pyplot.subplots(
        3, 1, sharex=True, layout="constrained", figsize=(7.2, 8.2),
        gridspec_kw={"height_ratios": (3., 1.6, 1.)})
    shares = [("potential_energy", "potential", "potential"),
              ("kinetic_energy", "kinetic", "kinetic"),
              ("elastic_energy", "elastic", "elastic"),
              ("dissipated_energy", "dissipated", "dissipated by the material"),
              ("transfer_loss", "transfer", "transfer loss")]
    if numpy.any(table["filter_loss"]):
        shares.append(("filter_loss", "filter", "pressure filter"))
    if numpy.any(table["damping"]):
        shares.append(("damping", "damping", "damping"))
    upper.stackplot(time, [numpy.maximum(table[name], 0.) / scale
                           for name, _, _ in shares],
                    colors=[COLOURS[colour] for _, colour, _ in shares],
                    labels=[label for _, _, label in shares], lw=0., alpha=0.9)
    upper.plot(time, (initial + table["boundary_work"]) / scale, "k--", lw=1.2,
               label="initial + boundary work")
    size = f"{scale:,.0f}" if scale >= 1000. else f"{scale:.4g}"
    upper.set_ylabel("stacked")
    upper.set_ylim(bottom=0.)
    handles, names = upper.get_legend_handles_labels()
    upper.legend(handles[::-1], names[::-1], loc="center left",
                 bbox_to_anchor=(1.01, 0.5))
    what = "initial potential" if table["potential_energy"][0] else "initial"
    upper.set_title(f"Energies over the {what} energy of {size} {unit}",
                    loc="left")

    small = [share for share in shares if share[0] not in
             ("potential_energy", "dissipated_energy")]
    small.append(("boundary_work", "boundary", "boundary work"))
    for name, colour, label in small:
        middle.plot(time, table[name] / scale, color=COLOURS[colour],
                    label=label, lw=1.5)
    middle.axhline(0., color="0.6", lw=0.6)
    middle.set_ylabel("not stacked")
    middle.legend(loc="center left", bbox_to_anchor=(1.01, 0.5))

    lower.plot(time, 100. * table["closure"], color=COLOURS["total"], lw=1.3)
    lower.axhline(0., color="0.6", lw=0.6)
    lower.set_ylabel("closure error [%]")
    lower.set_xlabel("time [s]")
    time_range(lower, table)
    save(figure, run.folder, "energies.png")


def settling(run):
    """How motion dies out in the stage that finds the initial equilibrium."""
    stage = run.stage[run.stage["elastic_energy"] > 0.]
    ratio = stage["kinetic_energy"] / stage["elastic_energy"]
    figure, axes = pyplot.subplots(layout="constrained", figsize=(7.2, 3.6))
    axes.semilogy(stage["time"] - run.stage["time"][0],
                  numpy.where(ratio > 0., ratio, numpy.nan),
                  color=COLOURS["kinetic"], lw=1.5)
    axes.set_xlabel("time since the start of the stage [s]")
    axes.set_ylabel("kinetic over elastic energy")
    axes.set_title("Initial equilibrium", loc="left")
    axes.grid(color="0.9", lw=0.6)
    save(figure, run.folder, "settling.png")


def front(runs, folder, name):
    """Front and height of one or several runs over time."""
    figure, both = pyplot.subplots(1, 2, layout="constrained",
                                   figsize=(9.2, 3.8))
    styles = ("-", "--", "-.", ":")
    for axes, column, colour, title in zip(
            both, ("front", "height"), ("#D55E00", "#0072B2"),
            ("front: 99.9 % of the mass lies behind",
             runs[0].height_label)):
        for number, run in enumerate(runs):
            label = f"{run.name} ({run.dimension}D)"
            axes.plot(run.table["time"], run.table[column], lw=1.8,
                      color=colour, ls=styles[number % len(styles)],
                      label=label)
            end = run.table[column][-1]
            if len(runs) == 1:
                axes.annotate(f"{end:.2f} m", (run.table["time"][-1], end),
                              xytext=(-4, 6), textcoords="offset points",
                              ha="right", color=colour)
        axes.set_title(title, loc="left")
        axes.set_xlabel("time [s]")
        axes.set_ylabel(f"{column} [m]")
        bottom, top = axes.get_ylim()
        axes.set_ylim(min(0., bottom), 1.06 * top)
        axes.grid(color="0.9", lw=0.6)
        time_range(axes, runs[0].table)
        if len(runs) > 1:
            axes.legend()
    save(figure, folder, name)
