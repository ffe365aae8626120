#!/usr/bin/python3
"""Noise of the pressure of the points of a run of mpm_granular.

    pressure_noise.py RUNFOLDER... [--times T,T,...] [--radius R]

The noise is the root mean square of p - p_mls over the mean of p: p_mls is what
a linear fit of moving least squares with the weights m (1 - r^2/R^2)^2 gives for
the points within R. Points whose surroundings hold less than half as much
material as the fullest ones are left out: at free surfaces, in edges, in the
air. R should be twice the size of the cells.
"""

import argparse
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from plotting.run import NotARun, Run  # noqa: E402


def neighbourhoods(position, radius):
    """Yields (points of a bin, points of this and the adjacent bins)."""
    bins = np.floor((position - position.min(axis=0)) / radius).astype(int)
    members = {}
    for index, key in enumerate(map(tuple, bins)):
        members.setdefault(key, []).append(index)
    members = {key: np.array(list_) for key, list_ in members.items()}
    offsets = np.stack(np.meshgrid(*[(-1, 0, 1)] * position.shape[1]),
                       -1).reshape(-1, position.shape[1])
    for key, inside in members.items():
        around = [members[tuple(np.add(key, offset))] for offset in offsets
                  if tuple(np.add(key, offset)) in members]
        yield inside, np.concatenate(around)


def smooth(position, value, volume, radius):
    """The fitted value and the volume around, at each point."""
    dim = position.shape[1]
    fitted = np.zeros(len(value))
    around_volume = np.zeros(len(value))
    for inside, around in neighbourhoods(position, radius):
        offset = position[around][None, :, :] - position[inside][:, None, :]
        square = np.sum(offset ** 2, axis=2) / radius ** 2
        near = square < 1.
        around_volume[inside] = near @ volume[around]
        weight = np.where(near, (1. - square) ** 2, 0.) * volume[around]
        basis = np.concatenate([np.ones(offset.shape[:2] + (1,)),
                                offset / radius], axis=2)
        matrix = np.einsum("ij,ija,ijb->iab", weight, basis, basis)
        matrix += 1e-9 * matrix[:, :1, :1] * np.eye(dim + 1)
        right = np.einsum("ij,ija,j->ia", weight, basis, value[around])
        fitted[inside] = np.linalg.solve(matrix, right[..., None])[:, 0, 0]
    return fitted, around_volume


def noise(run, index, radius):
    """Noise of the pressure in the points' file @p index."""
    points = run.points(index)
    position = points["position"][:, :run.dimension]
    fitted, around = smooth(position, points["pressure"], points["mass"],
                            radius)
    dense = around > .5 * around.max()
    deviation = points["pressure"][dense] - fitted[dense]
    return (np.sqrt(np.mean(deviation ** 2))
            / np.mean(points["pressure"][dense]))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="+", help="output folder of a run")
    parser.add_argument("--times", default="0.6,1,2",
                        help="instants, the nearest output of each [s]")
    parser.add_argument("--radius", type=float, default=.1, help="R [m], 0.1 unless given")
    options = parser.parse_args()
    times = [float(time) for time in options.times.split(",")]
    print("noise of the pressure at " + ", ".join(f"{t:g}" for t in times) + " s")
    for folder in options.folder:
        try:
            run = Run(folder)
        except NotARun as error:
            sys.exit(f"pressure_noise.py: {error}")
        print(" ".join(
            f"{noise(run, run.frame_at(time), options.radius):.3f}"
            for time in times), folder)


if __name__ == "__main__":
    main()
