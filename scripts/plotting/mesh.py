"""The mesh from the side, with the points, at several instants."""

import numpy
from matplotlib.collections import LineCollection

from .run import read_mesh
from .stages import label_edges, panel_grid
from .style import save

# Pairs of vertices that are edges of a cell, by its number of vertices; VTK's
# order.
EDGES = {
    (2, 3): [(0, 1), (1, 2), (2, 0)],
    (2, 4): [(0, 1), (1, 2), (2, 3), (3, 0)],
    (3, 4): [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)],
    (3, 8): [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4),
             (0, 4), (1, 5), (2, 6), (3, 7)],
}


def edges_from_the_side(run, frame):
    """Starts and ends of the edges one sees: of a mesh in space, those on its
    near side."""
    nodes, cells = read_mesh(run.folder / run.grid_frames[frame][1])
    pairs = numpy.array(EDGES[run.dimension, cells.shape[1]])
    edges = numpy.unique(numpy.sort(cells[:, pairs].reshape(-1, 2), axis=1),
                         axis=0)
    if run.dimension == 3:
        depth = nodes[:, run.depth]
        near = numpy.isclose(depth, depth.min(), atol=1e-9 * numpy.ptp(nodes))
        edges = edges[near[edges].all(axis=1)]
    return nodes[:, [run.horizontal, run.vertical]][edges]


def stages(run, name):
    """Four instants."""
    frames = run.stages(4)
    views = [edges_from_the_side(run, frame) for frame in frames]
    low, high = views[0].min(axis=(0, 1)), views[0].max(axis=(0, 1))
    bounds = low[0], high[0], low[1], high[1]
    figure, grid = panel_grid(-(-len(frames) // 2), min(len(frames), 2), bounds,
                              5.2)
    for axes in grid.flat[len(frames):]:
        axes.set_axis_off()
    for axes, frame, edges in zip(grid.T.flat, frames, views):
        place = run.points(frame)["position"]
        axes.plot(place[:, run.horizontal], place[:, run.vertical], ",",
                  color="#E69F00", rasterized=True)
        axes.add_collection(LineCollection(edges, linewidths=0.25,
                                           colors="#404040"))
        axes.set_xlim(bounds[0], bounds[1])
        axes.set_ylim(bounds[2], bounds[3])
        axes.set_aspect("equal")
        axes.set_title(f"$t$ = {run.frames[frame][0]:.2f} s", loc="right")
    label_edges(grid, run)
    save(figure, run.folder, name)
