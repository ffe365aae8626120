"""Perspective views of a body in space at several instants."""

import itertools

import numpy

from .splat import SAMPLES, PerspectiveView, draw
from .style import pyplot, save

SHAPE = 480, 860  # of a panel in pixels
LIGHT = numpy.array([-0.45, 0.65, 0.61])


def axis_vector(axis):
    """The unit vector along an axis."""
    return numpy.eye(3)[axis]


def make_view(run, low, high):
    """A camera that sees the box between `low` and `high`, from the front, the
    run-out side and above."""
    centre = 0.5 * (low + high)
    direction = (0.42 * axis_vector(run.horizontal)
                 - axis_vector(run.depth)
                 + 0.36 * axis_vector(run.vertical))
    direction /= numpy.linalg.norm(direction)
    size = numpy.linalg.norm(high - low)
    up = axis_vector(run.vertical)
    opening = numpy.deg2rad(24.)
    corners = numpy.array(list(itertools.product(*zip(low, high))))

    # Where the box is in the picture decides how far the camera stands.
    eye = centre + 3. * size * direction
    for _ in range(8):
        view = PerspectiveView(eye, centre, up, SHAPE, opening)
        column, row = view.place(corners)
        middle = (0.5 * (column.min() + column.max()) - 0.5 * SHAPE[1],
                  0.5 * (row.min() + row.max()) - 0.5 * SHAPE[0])
        distance = numpy.linalg.norm(eye - centre)
        metre = view.focal / SAMPLES / distance  # pixels
        shift = (middle[0] * view.right - middle[1] * view.up) / metre
        fill = max(numpy.ptp(column) / SHAPE[1], numpy.ptp(row) / SHAPE[0])
        centre = centre + shift
        eye = centre + direction * distance * fill / 0.93
    return PerspectiveView(eye, centre, up, SHAPE, opening)


def draw_ground(axes, view, run, low, high):
    """The floor of the box with lines, and labels of the distances."""
    along, across = run.horizontal, run.depth

    def place(horizontal, depth):
        position = low.copy()
        position[along], position[across] = horizontal, depth
        return [float(value[0]) for value in view.place(position)]

    corners = [place(low[along], low[across]), place(high[along], low[across]),
               place(high[along], high[across]), place(low[along],
                                                       high[across])]
    axes.fill(*zip(*corners), color="#ECE7DF", lw=0.6, ec="#8A8378", zorder=0)
    length = high[along] - low[along]
    step = 0.5 if length < 6. else 10. ** numpy.floor(numpy.log10(length / 3.))
    first = numpy.ceil((low[along] - run.spacing) / step) * step
    for mark in numpy.arange(first, high[along] + 1e-9, step):
        ends = place(mark, low[across]), place(mark, high[across])
        axes.plot(*zip(*ends), color="#8A8378", lw=0.5, zorder=1)
        axes.annotate(f"{mark + 0.:g} m", ends[0], xytext=(0, -3), ha="center",
                      va="top", textcoords="offset points", fontsize=8,
                      color="#5C564D", annotation_clip=False)


def perspective(run, quantity, name):
    """Six instants, in two columns that are read downwards."""
    frames = run.stages(6)
    positions = [run.points(frame)["position"] for frame in frames]
    low = numpy.min([numpy.percentile(p, 0.05, axis=0) for p in positions],
                    axis=0) - 0.5 * run.spacing
    high = numpy.max([numpy.percentile(p, 99.95, axis=0) for p in positions],
                     axis=0) + 0.5 * run.spacing
    margin = 0.04 * (high - low)[run.horizontal]
    high[run.horizontal] += margin
    start = positions[0][:, run.horizontal].min()
    if low[run.horizontal] < start - run.spacing:  # no wall on the left
        low[run.horizontal] -= margin
    view = make_view(run, low, high)

    n_columns = 2 if len(frames) > 1 else 1
    n_rows = -(-len(frames) // n_columns)
    figure, grid = pyplot.subplots(
        n_rows, n_columns, squeeze=False, layout="constrained",
        figsize=(5. * n_columns + 1., 5. * SHAPE[0] / SHAPE[1] * n_rows))
    for axes in grid.flat:
        axes.set_axis_off()
    for axes, frame in zip(grid.T.flat, frames):
        points = run.points(frame)
        draw_ground(axes, view, run, low, high)
        picture = draw(view, points["position"], 0.85 * run.spacing,
                       quantity.colours(points), LIGHT)
        axes.imshow(picture, zorder=2, interpolation="antialiased")
        axes.set_xlim(0, SHAPE[1])
        axes.set_ylim(SHAPE[0], 0)
        axes.text(0.97, 0.95, f"$t$ = {run.frames[frame][0]:.2f} s",
                  transform=axes.transAxes, ha="right", va="top")
    quantity.bar(figure, grid)
    save(figure, run.folder, name)
