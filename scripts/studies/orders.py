"""Observed orders of convergence, and errors estimated without an exact value.

Sizes h and values run from coarse to fine. Sources: Roache, Annu. Rev. Fluid
Mech. 29 (1997); Celik et al., J. Fluids Eng. 130 (2008) 078001.
"""

import dataclasses
import math


def observed_orders(sizes, errors):
    """The order between each pair of neighbouring levels, log(e1/e2)/log(h1/h2);
    not a number where an error is zero or none."""
    orders = []
    for (h1, e1), (h2, e2) in zip(zip(sizes, errors),
                                  zip(sizes[1:], errors[1:])):
        orders.append(math.log(e1 / e2) / math.log(h1 / h2)
                      if e1 > 0. and e2 > 0. else math.nan)
    return orders


@dataclasses.dataclass
class Estimate:
    """What three levels tell about the limit of a value."""
    order: float         # observed
    extrapolated: float  # Richardson's value for h = 0
    gci: float           # grid convergence index: relative error bar of the
                         # finest value, with the safety factor 1.25
    is_monotone: bool    # whether the three values approach a limit

    @property
    def is_credible(self):
        """Whether the limit says anything: with orders below 1/2 it lies far
        outside of the values and follows from their noise."""
        return self.is_monotone and self.order >= .5


def estimate(sizes, values):
    """The estimate from the three finest levels. Where they do not approach a
    limit monotonically, there is no order: all numbers are nan."""
    none = Estimate(math.nan, math.nan, math.nan, False)
    if len(values) < 3:
        return none
    (h3, h2, h1), (f3, f2, f1) = sizes[-3:], values[-3:]
    coarse, fine = f3 - f2, f2 - f1
    if fine == 0. or coarse / fine <= 1.:
        return none
    r21, r32 = h2 / h1, h3 / h2
    order = 1.
    for _ in range(200):  # fixed point of Celik et al., eq. 3
        shift = math.log((r21**order - 1.) / (r32**order - 1.))
        new = abs(math.log(coarse / fine) + shift) / math.log(r21)
        if abs(new - order) < 1e-12:
            break
        order = new
    extrapolated = f1 - fine / (r21**order - 1.)
    gci = (1.25 * abs(fine / f1) / (r21**order - 1.) if f1 != 0. else math.nan)
    return Estimate(order, extrapolated, gci, True)
