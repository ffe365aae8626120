"""Side views of a body at several instants."""

import numpy
from matplotlib.cm import ScalarMappable
from matplotlib.colors import ListedColormap, Normalize

from .run import AXES
from .splat import SideView, draw
from .style import pyplot, round_up, save

PIXELS = 800  # across a panel

# Without the darkest colours, so that unstrained sand does not look black.
STRAIN_MAP = ListedColormap(pyplot.get_cmap("viridis")(
    numpy.linspace(0.1, 1., 256)))


class Quantity:
    """A field as it is drawn, with a range for all panels of a figure."""

    def __init__(self, field, label, factor, colour_map, largest):
        self.field = field
        self.label = label
        self.factor = factor
        self.map = colour_map
        self.norm = Normalize(0., largest)

    def colours(self, points):
        """Colour of each point."""
        values = self.factor * points[self.field]
        return self.map(self.norm(values))[:, :3]

    def bar(self, figure, axes):
        """The colour bar beside `axes`."""
        bar = figure.colorbar(ScalarMappable(self.norm, self.map), ax=axes,
                              extend="max", fraction=0.03, pad=0.02, aspect=28,
                              shrink=0.75)
        bar.set_label(self.label)
        bar.outline.set_linewidth(0.6)


def strain(runs):
    """Where the body has sheared."""
    name, label = runs[0].strain_field()
    largest = max(numpy.percentile(run.points(len(run.frames) - 1)[name], 95)
                  for run in runs)
    if name == "speed":
        largest = max(numpy.percentile(run.points(frame)[name], 99)
                      for run in runs for frame in run.stages(6))
    return Quantity(name, label, 1., STRAIN_MAP, round_up(largest))


def pressure(runs):
    """Pressure, up to nearly the highest of what is shown."""
    largest = max(numpy.percentile(run.points(frame)["pressure"], 98)
                  for run in runs for frame in run.stages(6))
    return Quantity("pressure", "pressure [kPa]", 1e-3,
                    pyplot.get_cmap("magma"), round_up(1e-3 * largest))


def view_bounds(runs, frames):
    """What all the frames need: left, right, bottom, top [m]. A few points
    that fly far away are left out."""
    low, high = [], []
    for run, numbers in zip(runs, frames):
        for number in numbers:
            place = run.points(number)["position"][:, [run.horizontal,
                                                       run.vertical]]
            low.append(numpy.percentile(place, 0.05, axis=0))
            high.append(numpy.percentile(place, 99.95, axis=0))
    start = low[0]
    low, high = numpy.min(low, axis=0), numpy.max(high, axis=0)
    margin = 0.04 * (high - low).max()
    # The body stands on the lower edge, and at a wall on the left unless it
    # moves there.
    spacing = max(run.spacing for run in runs)
    left, bottom = low - spacing
    if left < start[0] - 2. * spacing:
        left = low[0] - margin
    right, top = high + margin
    return left, right, bottom, top


def panel(axes, run, frame, quantity, bounds):
    """One instant seen from the side."""
    points = run.points(frame)
    view = SideView(run.horizontal, run.vertical, run.depth, bounds,
                    PIXELS / (bounds[1] - bounds[0]))
    picture = draw(view, points["position"], run.spacing,
                   quantity.colours(points))
    axes.imshow(picture, extent=bounds, interpolation="antialiased",
                aspect="equal")
    axes.set_xlim(bounds[0], bounds[1])
    axes.set_ylim(bounds[2], bounds[3])
    axes.text(0.97, 0.93, f"$t$ = {run.frames[frame][0]:.2f} s",
              transform=axes.transAxes, ha="right", va="top")


def label_edges(grid, run):
    """Axis labels at the left and lower edge of a grid of panels."""
    for row in grid:
        row[0].set_ylabel(f"{AXES[run.vertical]} [m]")
        for axes in row[1:]:
            axes.tick_params(labelleft=False)
    for axes in grid[-1]:
        axes.set_xlabel(f"{AXES[run.horizontal]} [m]")
    for row in grid[:-1]:
        for axes in row:
            axes.tick_params(labelbottom=False)


def panel_grid(n_rows, n_columns, bounds, panel_width):
    """A figure with panels of the proportions of the bounds."""
    proportion = (bounds[3] - bounds[2]) / (bounds[1] - bounds[0])
    figure, grid = pyplot.subplots(
        n_rows, n_columns, squeeze=False, layout="compressed",
        figsize=(panel_width * n_columns + 1.2,
                 (panel_width * proportion + 0.15) * n_rows + 0.7))
    return figure, grid


def stages(run, quantity, name):
    """Six instants, in two columns that are read downwards."""
    frames = run.stages(6)
    bounds = view_bounds([run], [frames])
    n_columns = 2 if len(frames) > 1 else 1
    n_rows = -(-len(frames) // n_columns)
    figure, grid = panel_grid(n_rows, n_columns, bounds, 4.6)
    for axes in grid.flat[len(frames):]:
        axes.set_axis_off()
    for axes, frame in zip(grid.T.flat, frames):
        panel(axes, run, frame, quantity, bounds)
    label_edges(grid, run)
    quantity.bar(figure, grid)
    save(figure, run.folder, name)


def compare(runs, quantity, name):
    """The same instants of two runs side by side."""
    times = [runs[0].frames[frame][0] for frame in runs[0].stages(6)]
    frames = [[run.frame_at(time) for time in times] for run in runs]
    bounds = view_bounds(runs, frames)
    figure, grid = panel_grid(len(times), len(runs), bounds, 4.2)
    for column, run in enumerate(runs):
        count = len(run.points(0)["position"])
        grid[0][column].set_title(f"{run.dimension}D: {run.name}, "
                                  f"{count:,} points")
        for row, frame in enumerate(frames[column]):
            panel(grid[row][column], run, frame, quantity, bounds)
    label_edges(grid, runs[0])
    if runs[0].vertical != runs[1].vertical:
        for row in grid:
            row[0].set_ylabel("height [m]")
    quantity.bar(figure, grid)
    save(figure, runs[0].folder, name)
