"""What all figures have in common."""

import matplotlib

matplotlib.use("Agg")

from matplotlib import pyplot  # noqa: E402  (after the choice of Agg)
import numpy  # noqa: E402

pyplot.rcParams.update({
    "font.size": 11,
    "axes.titlesize": 11,
    "axes.labelsize": 11,
    "legend.fontsize": 10,
    "legend.frameon": False,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.axisbelow": True,
    "figure.facecolor": "white",
    "savefig.dpi": 160,
})

# Distinct for colour-blind readers (Okabe and Ito).
COLOURS = {"kinetic": "#D55E00", "elastic": "#56B4E9", "potential": "#0072B2",
           "dissipated": "#E69F00", "transfer": "#CC79A7", "boundary":
           "#009E73", "filter": "#F0E442", "damping": "#999999",
           "total": "#000000"}


def round_up(value):
    """The next number of the series 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, ..."""
    if not value > 0.:
        return 1.
    power = 10. ** numpy.floor(numpy.log10(value))
    for factor in (1., 1.5, 2., 2.5, 3., 4., 5., 6., 8., 10.):
        if value <= factor * power * (1. + 1e-9):
            return factor * power
    return 10. * power


def save(figure, folder, name):
    """Writes the picture and says where."""
    pictures = folder / "pictures"
    pictures.mkdir(exist_ok=True)
    figure.savefig(pictures / name, bbox_inches="tight", pad_inches=0.08)
    pyplot.close(figure)
    print(pictures / name)
