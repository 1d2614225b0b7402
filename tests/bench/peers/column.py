"""The column of the reference set in reduced units: mass of a bead 1, time in tc, length in v0 tc.

Contacts: force K x + C x', Eqs. (2), (3), (6), (7): mu = -ln eps, K = (pi^2 + mu^2)/2, C = mu, the same for the wall.
"""

import math

BEADS = 10
EPSILON = 0.9
DASHPOT = -math.log(EPSILON)
SPRING = 0.5 * (math.pi**2 + DASHPOT**2)
# Diameter of a bead: much more than an overlap, so that neighbours' lists need no second look, and little enough for
# positions to keep twelve digits.
DIAMETER = 1000.0
DENSITY = 6.0 / (math.pi * DIAMETER**3)


def centres(tuple_, step):
    """Heights of the beads' centres; the first contact occurs at the tuple's phase of a step."""
    gap, first = tuple_["gap"], tuple_["phase"] * step
    return [(i + 1) * gap + first + (i + 0.5) * DIAMETER for i in range(BEADS)]


def steps_of(tuple_, steps_per_tc):
    """The number of steps until the collision is over. A user has to find it by trying: it costs nothing here."""
    return math.ceil(tuple_["duration"] * steps_per_tc) + 2


def height(tuple_):
    """A height that no bead reaches."""
    return BEADS * (DIAMETER + tuple_["gap"]) + 3.0 * tuple_["duration"] + DIAMETER


def eps_eff(velocities):
    """sqrt(E_f/E_0) with initial velocities of -1."""
    return math.sqrt(sum(v * v for v in velocities) / len(velocities))
