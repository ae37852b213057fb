# SPDX-License-Identifier: LGPL-2.1-or-later
"""How near to sin(θ/2) the ratio of a unit between leaning contacts may come.

On a plane the two secondary triangles of a sub-unit come into one plane as the ratio falls to
sin(θ/2); beyond that the fold P-C' between them turns inside out. Where contact panels lean (a
curve that climbs along the legs) one of the two sub-units comes there at a larger ratio already.
That ratio is to it what sin(θ/2) is to an upright one: the share of a ratio, and with it how hard
the sub-unit snaps, counts from there.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .contacts import check_opening, normalised_contacts
from .general import bases, solve, symmetric_start, unfolded
from .shape import apex_folds

_NEAR = 1e-3  # share at which an upright unit still folds the right way
_FAR = 0.6
_STEPS, _SOLVED_STEPS = 9, 3


@dataclass(frozen=True)
class Leaning:
    """What leaning contacts change for n units.

    ``least`` (n, 2): the least ratio of the upper and of the lower sub-unit; ``size`` (n,): length
    across the legs, by which these units snap as if they were smaller: √(|A'B| / ‖AB‖), A' being
    the point of A's leg that is level with B (it fits what `margin.assess` measures).
    """

    least: np.ndarray
    size: np.ndarray

    def __getitem__(self, units: slice) -> "Leaning":
        return Leaning(self.least[units], self.size[units])


def leaning(contact_left: NDArray, contact_right: NDArray) -> tuple:
    """Opening θ (n,), radians, and `Leaning` of units between contacts (n, 4, 3).

    ValueError for contacts that do not open between 0° and 180°.
    """
    quads, _, _ = normalised_contacts(contact_left, contact_right)
    level, tilted, _ = bases(quads, unfolded(quads))
    theta = level["upper"].theta
    check_opening(theta)
    widest = np.max([base.theta for by_end in (level, tilted) for base in by_end.values()], axis=0)
    low = np.sin(np.where(widest - theta > 1e-12, widest, theta) / 2)
    least = np.stack([low, low], 1)
    near = np.full(len(low), _NEAR)
    for end in (0, 1):
        some = np.flatnonzero(_folds(quads, low, near)[:, end] <= 0)
        if len(some):
            share = _least_share(quads[some], low[some], end)
            least[some, end] += share * (1 - low[some])
    return theta, Leaning(least, np.sqrt(level["upper"].length))


def _least_share(quads: NDArray, low: NDArray, end: int) -> NDArray:
    """Shares (n,) of the way from ``low`` to 1 from which on the fold P-C' turns the right way.

    Those of the start, which is near; then of the solved unit, at most half as much again.
    """
    share = _bisected(quads, low, end, _NEAR * np.ones_like(low), _FAR, _STEPS)
    return _bisected(quads, low, end, share, 1.5 * share + _NEAR, _SOLVED_STEPS, solved=True)


def _bisected(
    quads: NDArray,
    low: NDArray,
    end: int,
    wrong: NDArray,
    right: NDArray | float,
    steps: int,
    solved: bool = False,
) -> Any:
    for _ in range(steps):
        middle = np.minimum((wrong + right) / 2, _FAR)
        good = _folds(quads, low, middle, solved)[:, end] > 0
        wrong, right = np.where(good, wrong, middle), np.where(good, middle, right)
    return right


def _folds(quads: NDArray, low: NDArray, share: NDArray, solved: bool = False) -> NDArray:
    _, deployed, flat = symmetric_start(quads, low + share * (1 - low))
    if solved:
        solve(deployed, flat)
    return apex_folds(deployed)
