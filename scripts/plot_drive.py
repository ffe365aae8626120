#!/usr/bin/python3
"""A picture of a test of one material point, `mpm_granular --drive FILE`.

    plot_drive.py FOLDER [FOLDER ...]

writes FOLDER/pictures/drive.png: the equivalent stress over the strain, the
volumetric strain over the strain, and the path of the stress with the yield
line. With several folders all of them are drawn into the picture of the first
one.

It needs the Debian packages python3-matplotlib and python3-numpy, and no
display.
"""

import argparse
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

try:
    import numpy
    from plotting.style import pyplot, save
except ImportError as error:
    sys.exit(f"plot_drive.py: {error}. It needs the Debian packages "
             "python3-matplotlib and python3-numpy, and Debian's "
             f"/usr/bin/python3 (this is {sys.executable}).")

# Distinct for colour-blind readers (Okabe and Ito).
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")


class Drive:
    """The files of one test."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.table = self._read("drive.csv")
        self.yield_line = self._read("yield.csv")
        try:
            text = (self.folder / "parameters.prm").read_text(encoding="utf8")
        except OSError as error:
            sys.exit(f"plot_drive.py: {error}.")
        self.test = self._entry(text, "Test")
        self.law = self._entry(text, "Law")

    def _read(self, name):
        try:
            return numpy.genfromtxt(self.folder / name, delimiter=",",
                                    names=True, ndmin=1)
        except OSError as error:
            sys.exit(f"plot_drive.py: {error}. Is this the folder of "
                     "mpm_granular --drive?")

    @staticmethod
    def _entry(text, name):
        match = re.search(rf"^\s*set {name}\s*=\s*([^#\n]*)", text, re.M)
        return match[1].strip() if match else ""


def unit_of(drives):
    """kPa or Pa, whatever is shorter."""
    largest = max(abs(drive.table[name]).max() for drive in drives
                  for name in ("p", "q"))
    return (1e3, "kPa") if largest >= 1e3 else (1., "Pa")


def draw(drives):
    """The three panels."""
    scale, unit = unit_of(drives)
    figure, (stress, volume, path) = pyplot.subplots(
        1, 3, figsize=(12.6, 3.9), layout="constrained")
    largest_q = max(drive.table["q"].max() for drive in drives) / scale
    for number, drive in enumerate(drives):
        colour = COLOURS[number % len(COLOURS)]
        table = drive.table
        percent = 100. * table["strain"]
        label = (f"{drive.folder.name}: {drive.law}" if len(drives) > 1
                 else "path of the stress")
        stress.plot(percent, table["q"] / scale, color=colour)
        volume.plot(percent, 100. * table["volumetric_strain"], color=colour)
        line = drive.yield_line
        if line.size:
            path.plot(line["p"] / scale, line["q"] / scale, color=colour,
                      ls="--", lw=1.1,
                      label="yield line" if len(drives) == 1 else None)
        path.plot(table["p"] / scale, table["q"] / scale, color=colour, lw=1.8,
                  label=label)
        path.plot(table["p"][:1] / scale, table["q"][:1] / scale, "o",
                  color=colour, ms=5, clip_on=False, zorder=5)

    name = ("shear strain" if "shear" in drives[0].test else
            "axial strain") + " [%]"
    stress.set_xlabel(name)
    stress.set_ylabel(f"q [{unit}]")
    stress.set_title(f"equivalent stress, up to {largest_q:.4g} {unit}",
                     loc="left")
    volume.set_xlabel(name)
    volume.set_ylabel("volumetric strain [%]")
    volume.set_title("volume, growth positive", loc="left")
    volume.axhline(0., color="0.6", lw=.6)
    least = .02 * abs(numpy.array(volume.get_xlim())).max()
    if max(abs(numpy.array(volume.get_ylim()))) < least:
        volume.set_ylim(-least, least)
    path.set_xlabel(f"p [{unit}]")
    path.set_ylabel(f"q [{unit}]")
    path.set_title("path of the stress", loc="left")
    path.set_ylim(0., 1.35 * largest_q or 1.)
    stress.set_ylim(bottom=0.)
    for axes in (stress, volume, path):
        axes.grid(color="0.92", lw=.8)
    path.legend(loc="upper left")
    title = drives[0].test
    if len(drives) == 1:
        title += f", {drives[0].law}"
    figure.suptitle(title, x=.01, ha="left", fontweight="bold")
    save(figure, drives[0].folder, "drive.png")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="+",
                        help="output folder of mpm_granular --drive")
    draw([Drive(folder) for folder in parser.parse_args().folder])


if __name__ == "__main__":
    main()
