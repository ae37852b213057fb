# SPDX-License-Identifier: LGPL-2.1-or-later
"""A gentler curve: the one of least change, in the mean, for so much less bending."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .kinds import evenly

if TYPE_CHECKING:
    from .curve import Curve

_POINTS = 320


class Spline:
    """A natural cubic through points (n, 3), by chord length; periodic where ``closed``."""

    def __init__(self, points: NDArray, closed: bool = False) -> None:
        points = np.asarray(points, float)
        steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
        self.knots = np.concatenate([[0], np.cumsum(steps)]) / steps.sum()
        self.points = points
        self.breaks = self.knots.tolist()
        self.second = _second(self.knots, points, closed)

    def point(self, s: ArrayLike) -> NDArray:
        """Points (…, 3) at ``s`` in [0, 1]."""
        s = np.asarray(s, float)
        k = np.clip(np.searchsorted(self.knots, s, "right") - 1, 0, len(self.knots) - 2)
        width = (self.knots[k + 1] - self.knots[k])[..., None]
        before = (self.knots[k + 1] - s)[..., None] / width
        after = 1 - before
        bend = (before**3 - before) * self.second[k] + (after**3 - after) * self.second[k + 1]
        return before * self.points[k] + after * self.points[k + 1] + bend * width**2 / 6


def _second(knots: NDArray, points: NDArray, closed: bool) -> NDArray:
    """Second derivatives (n, 3) of the cubic at its knots."""
    n, h = len(knots), np.diff(knots)
    system, right = np.zeros((n, n)), np.zeros((n, 3))
    slopes = np.diff(points, axis=0) / h[:, None]
    k = np.arange(1, n - 1)
    system[k, k - 1], system[k, k], system[k, k + 1] = h[:-1], 2 * (h[:-1] + h[1:]), h[1:]
    right[k] = 6 * np.diff(slopes, axis=0)
    if closed:
        system[0, [0, 1, -2]] = 2 * (h[0] + h[-1]), h[0], h[-1]
        right[0] = 6 * (slopes[0] - slopes[-1])
        system[-1, [0, -1]] = 1, -1
    else:
        system[0, 0] = system[-1, -1] = 1
    return np.linalg.solve(system, right)


def smooth(curve: "Curve", count: int) -> Spline:
    """A `Spline` through ``count`` points of a curve, evenly along it; closed as the curve is."""
    points = evenly(curve, count)
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return Spline(points, bool(np.linalg.norm(points[0] - points[-1]) < 1e-6 * steps.sum()))


def gentler(curve: "Curve", width: float) -> tuple[Spline, float]:
    """A `Spline` that bends less than ``curve`` over a ``width`` (mm), and its largest change (mm).

    Least squares of the change plus ``width``⁴ times those of the second derivative by length. Both
    ends stay where they are; a closed curve stays closed.
    """
    points = evenly(curve, _POINTS)
    step = np.linalg.norm(np.diff(points, axis=0), axis=1).mean()
    closed = np.linalg.norm(points[0] - points[-1]) < 1e-6 * step * _POINTS
    n = len(points) - closed
    bend = np.zeros((n - 2 + 2 * closed, n))
    row = np.arange(len(bend))
    for column, weight in ((0, 1), (1, -2), (2, 1)):
        bend[row, (row + column) % n] = weight
    stiff = np.eye(n) + (width / step) ** 4 * bend.T @ bend
    target = points[:n].copy()
    if not closed:  # ends are held
        held = np.zeros(n, bool)
        held[[0, -1]] = True
        right = target[~held] - stiff[np.ix_(~held, held)] @ target[held]
        moved = target.copy()
        moved[~held] = np.linalg.solve(stiff[np.ix_(~held, ~held)], right)
    else:
        moved = np.linalg.solve(stiff, target)
        moved = np.concatenate([moved, moved[:1]])
    change = float(np.linalg.norm(moved - points, axis=1).max())
    return Spline(moved, bool(closed)), change
