"""Drawing many points as small spheres or discs, nearest on top.

This needs neither a display nor OpenGL; a million points take seconds.
"""

import numpy

SAMPLES = 2  # of a pixel in each direction, averaged in the end


class SideView:
    """A camera that looks horizontally, from infinitely far away."""

    def __init__(self, horizontal, vertical, depth, bounds, pixels_per_metre):
        self.axes = horizontal, vertical, depth
        self.bounds = bounds  # left, right, bottom, top [m]
        self.scale = SAMPLES * pixels_per_metre
        left, right, bottom, top = bounds
        self.shape = (max(1, round((top - bottom) * pixels_per_metre)),
                      max(1, round((right - left) * pixels_per_metre)))

    def project(self, positions):
        """Column, row, distance [m] and pixels a metre of each position."""
        horizontal, vertical, depth = self.axes
        left, _, _, top = self.bounds
        return (self.scale * (positions[:, horizontal] - left),
                self.scale * (top - positions[:, vertical]),
                positions[:, depth],
                numpy.full(len(positions), self.scale))


class PerspectiveView:
    """A camera at `eye` [m] that looks at `target`."""

    def __init__(self, eye, target, up, shape, opening):
        forward = target - eye
        self.eye = eye
        self.forward = forward / numpy.linalg.norm(forward)
        right = numpy.cross(self.forward, up)
        self.right = right / numpy.linalg.norm(right)
        self.up = numpy.cross(self.right, self.forward)
        self.shape = shape
        self.focal = SAMPLES * 0.5 * shape[1] / numpy.tan(0.5 * opening)

    def project(self, positions):
        """Column, row, distance [m] and pixels a metre of each position."""
        relative = positions - self.eye
        distance = relative @ self.forward
        scale = self.focal / numpy.maximum(distance, 1e-9)
        return (0.5 * SAMPLES * self.shape[1] + scale * (relative @ self.right),
                0.5 * SAMPLES * self.shape[0] - scale * (relative @ self.up),
                distance, scale)

    def place(self, positions):
        """Column and row of each position in the final picture."""
        column, row, _, _ = self.project(numpy.atleast_2d(positions))
        return column / SAMPLES, row / SAMPLES


def footprint(view, positions, radius):
    """Yields, for each sample of the spheres' pictures, the indices of the
    points that have it, the sample it is in, its distance, and the components
    of the sphere's normal (right, up) there."""
    column, row, distance, scale = view.project(positions)
    size = radius * scale
    reach = int(numpy.ceil(size.max(initial=0.)))
    height, width = (SAMPLES * n for n in view.shape)
    first_column = numpy.floor(column).astype(int)
    first_row = numpy.floor(row).astype(int)
    for step_row in range(-reach, reach + 1):
        for step_column in range(-reach, reach + 1):
            i, j = first_row + step_row, first_column + step_column
            right = (j + 0.5 - column) / size
            up = (row - i - 0.5) / size
            square = right ** 2 + up ** 2
            which = numpy.nonzero((square <= 1.) & (i >= 0) & (i < height)
                                  & (j >= 0) & (j < width))[0]
            bulge = radius * numpy.sqrt(1. - square[which])
            yield (which, i[which] * width + j[which], distance[which] - bulge,
                   right[which], up[which])


def draw(view, positions, radius, colours, light=None):
    """The picture (rows, columns, RGBA) of points as spheres.

    positions: (n, 3) [m]; radius of the spheres [m]; colours: (n, 3), 0 to 1;
    light: direction to the light (right, up, towards the eye), None for flat
    colours.
    """
    # From far to near: where several points have a sample, the last one counts.
    order = numpy.argsort(-view.project(positions)[2], kind="stable")
    positions, colours = positions[order], colours[order]

    height, width = (SAMPLES * n for n in view.shape)
    nearest = numpy.full(height * width, numpy.inf)
    picture = numpy.zeros((height * width, 4))
    for which, sample, distance, right, up in footprint(view, positions,
                                                        radius):
        seen = distance < nearest[sample]
        which, sample = which[seen], sample[seen]
        nearest[sample] = distance[seen]
        shade = 1.
        if light is not None:
            right, up = right[seen], up[seen]
            towards = numpy.sqrt(numpy.maximum(0., 1. - right ** 2 - up ** 2))
            lit = right * light[0] + up * light[1] + towards * light[2]
            shade = (0.5 + 0.5 * numpy.maximum(0., lit))[:, None]
        picture[sample, :3] = colours[which] * shade
        picture[sample, 3] = 1.

    picture = picture.reshape(view.shape[0], SAMPLES, view.shape[1], SAMPLES, 4)
    alpha = picture[..., 3].mean(axis=(1, 3))
    colour = (picture[..., :3] * picture[..., 3:]).mean(axis=(1, 3))
    result = numpy.zeros(view.shape + (4,))
    result[..., 3] = alpha
    covered = alpha > 0.
    result[covered, :3] = colour[covered] / alpha[covered][:, None]
    return numpy.clip(result, 0., 1.)
