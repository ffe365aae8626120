"""Errors over the size of cells or steps."""

import io

import numpy
from PIL import Image

from .style import pyplot

# Distinct for colour-blind readers (Okabe and Ito), with markers of their own.
LINES = [("#0072B2", "o"), ("#D55E00", "s"), ("#009E73", "^"), ("#CC79A7", "D"),
         ("#E69F00", "v"), ("#56B4E9", "P"), ("#000000", "x")]

HEIGHT = 3.9  # of figures [inches]


def line_style(index):
    """Colour, marker and dashes of line number `index`."""
    colour, marker = LINES[index % len(LINES)]
    dashes = ["-", "--", ":"][index // len(LINES) % 3]
    return {"color": colour, "marker": marker, "markersize": 5,
            "linewidth": 1.4, "linestyle": dashes,
            "markerfacecolor": colour if index < len(LINES) else "white"}


def draw_convergence(axes, series, orders=(), size_label="size of cells h [m]",
                     error_label="relative error"):
    """Lines of errors in logarithmic axes, with a legend.

    series: {label: (sizes, errors)}; orders: slopes drawn for comparison, grey,
    below the first line at its coarsest size.
    """
    for index, (label, (sizes, errors)) in enumerate(series.items()):
        axes.loglog(sizes, errors, label=label, **line_style(index))
    sizes, errors = next(iter(series.values()))
    ends = numpy.array([max(sizes), min(sizes)])
    for order, dashes in zip(orders, (":", "--", "-.")):
        axes.loglog(ends, .6 * max(errors) * (ends / ends[0])**order,
                    color="0.5", linestyle=dashes, linewidth=1.,
                    label=f"order {order:g}")
    axes.set_xlabel(size_label)
    axes.set_ylabel(error_label)
    axes.grid(True, which="major", color="0.9", linewidth=.8)
    every = sorted({size for line, _ in series.values() for size in line})
    if len(every) <= 8:
        axes.set_xticks(every)
        axes.set_xticklabels([f"{size:.3g}" for size in every])
        axes.minorticks_off()
    if len(series) <= 4:
        axes.legend(fontsize=9)
    else:
        # Room for the lines of the legend, or labels beside the axes are cut.
        axes.figure.set_figheight(HEIGHT + .12 * len(series))
        axes.legend(fontsize=8, ncol=2, loc="upper center",
                    bbox_to_anchor=(.5, -.2))


def new_figure(n_panels=1):
    """A figure with panels side by side."""
    figure, axes = pyplot.subplots(1, n_panels, squeeze=False,
                                   figsize=(5.6 * n_panels, HEIGHT))
    return figure, list(axes[0])


def save_small(figure, path):
    """Writes a picture for a document: 64 colours, some ten kB."""
    figure.tight_layout()
    full = io.BytesIO()
    figure.savefig(full, format="png", dpi=110, bbox_inches="tight",
                   pad_inches=.06)
    pyplot.close(figure)
    Image.open(full).convert("RGB").quantize(64).save(path, optimize=True)
