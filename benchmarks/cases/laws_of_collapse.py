"""What experiments found for columns of grains that collapse on a floor.

All lengths over the initial width (of half a column in a channel) or radius, as
functions of a = height/width; times over sqrt(height/gravity).
"""

import dataclasses

import numpy


@dataclasses.dataclass
class Laws:
    """Laws of one series of experiments.

    run_out: how much further than at the start the front is at the end; height:
    of the deposit; duration: until the front stands; in words: the same.
    """
    who: str
    run_out: callable
    height: callable
    duration: float
    words: list


def _between(low, high, law_below, law_above):
    """A law below `low`, another one above `high`, a straight line between."""
    def value(aspect):
        aspect = numpy.asarray(aspect, dtype=float)
        share = numpy.clip((aspect - low) / (high - low), 0., 1.)
        line = (1 - share) * law_below(low) + share * law_above(high)
        return numpy.where(aspect < low, law_below(aspect),
                           numpy.where(aspect > high, law_above(aspect), line))
    return value


# Phys. Rev. E 72 (2005) 041301.
LUBE_PLANE = Laws(
    "Lube et al. 2005",
    _between(1.8, 2.8, lambda a: 1.2 * a, lambda a: 1.9 * a**(2 / 3)),
    lambda a: numpy.minimum(a, 1.1 * a**.4), 3.3,
    ["1.2 a (a < 1.8), 1.9 a^(2/3) (a > 2.8)",
     "a, at most 1.1 a^(2/5)", "3.3"])

# J. Fluid Mech. 508 (2004) 175.
LUBE_ROUND = Laws(
    "Lube et al. 2004",
    lambda a: numpy.minimum(1.24 * a, 1.6 * a**.5),
    lambda a: numpy.minimum(a, .88 * a**(1 / 6)), 3.,
    ["1.24 a, at most 1.6 a^(1/2)",
     "a, at most 0.88 a^(1/6)", "3.0"])

# Phys. Fluids 17 (2005) 103302: the lines of its figures, whose points scatter by
# 10 to 20 per cent about them.
LAJEUNESSE_PLANE = Laws(
    "Lajeunesse et al. 2005",
    lambda a: numpy.minimum(1.8 * a, 2.6 * a**(2 / 3)),
    lambda a: numpy.minimum(a, .9 * a**(1 / 3)), 3.,
    ["1.8 a, at most 2.6 a^(2/3)",
     "a, at most 0.9 a^(1/3)", "3"])

LAJEUNESSE_ROUND = Laws(
    "Lajeunesse et al. 2005",
    lambda a: numpy.minimum(1.2 * a, 1.8 * a**.5),
    lambda a: numpy.minimum(a, .7), 3.,
    ["1.2 a, at most 1.8 a^(1/2)", "a, at most 0.7", "3"])


def table_of_laws(suite, laws):
    """The laws in words."""
    suite.table(["experiments", "(run-out - L)/L", "height/L",
                 "time / sqrt(H/g)"], [[law.who, *law.words] for law in laws])


def draw_laws(axes, laws, quantity, aspects):
    """Grey lines of laws in logarithmic axes."""
    fine = numpy.geomspace(min(aspects), max(aspects), 200)
    for law, dashes in zip(laws, ("-", "--")):
        axes.loglog(fine, getattr(law, quantity)(fine), color="0.4",
                    linestyle=dashes, linewidth=1.2, label=law.who)
    axes.set_xlabel("initial aspect ratio a")
    axes.set_xticks(aspects, [f"{aspect:g}" for aspect in aspects])
    axes.minorticks_off()


def deviation(value, expected):
    """In per cent."""
    return f"{100 * (value / float(expected) - 1):+.0f} %"
