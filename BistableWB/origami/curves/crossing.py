# SPDX-License-Identifier: LGPL-2.1-or-later
"""First crossing of a curve with a growing condition, found without a step size.

The curve is tabulated once: nodes, and for every interval a bound on how far the curve strays from
its chord. An interval can be skipped only if even the bound leaves no room for a crossing, so a
narrow excursion between two nodes is not missed.
"""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from .curve import Curve

_CHUNK = 32
_FIRST = 512
_PIECE = 8  # nodes inside every piece of a curve made of pieces
_SPLIT = 16
_DEEPEST = 3
_SAME = 1e-9  # parameters closer than this differ by rounding: a knot at k/512 is a node already
_SAFETY = 2.0  # sampled deviation -> bound; the true maximum lies between the samples


class CurveTable:
    """Nodes of ``curve`` (anything with ``point(s)``), refined for features of size ``scale``.

    ``parameters`` (m,), ``points`` (m, 3), ``lengths`` (m,) cumulated along the chords,
    ``deviations`` (m − 1,): bound on the distance of the curve from each chord. The bound is strict
    for a curve that gives ``bend``, a bound on its second derivative by s; else it is sampled, so a
    curve made of pieces should give ``breaks``, the parameters where they meet.
    """

    def __init__(self, curve: "Curve", scale: float) -> None:
        self.curve = curve
        s = _first_nodes(getattr(curve, "breaks", ()))
        points = np.asarray(curve.point(s), float)
        for _ in range(30):
            deviation = self._deviations(s, points)
            chord = np.linalg.norm(np.diff(points, axis=0), axis=1)
            coarse = (chord > scale / 4) | (deviation > scale / 200)
            coarse &= np.diff(s) > _SAME
            if not coarse.any():
                break
            middle = (s[:-1][coarse] + s[1:][coarse]) / 2
            order = np.argsort(s := np.concatenate([s, middle]), kind="stable")
            points = np.concatenate([points, curve.point(middle)])[order]
            s = s[order]
        self.parameters, self.points, self.deviations = s, points, self._deviations(s, points)
        self.lengths = np.concatenate(
            [[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))]
        )

    def _deviations(self, s: NDArray, points: NDArray) -> NDArray:
        if hasattr(self.curve, "bend"):
            return self.curve.bend * np.diff(s) ** 2 / 8
        worst = np.zeros(len(s) - 1)
        start, chord = points[:-1], np.diff(points, axis=0)
        square = np.maximum((chord * chord).sum(1), 1e-300)
        for fraction in (0.25, 0.5, 0.75):
            offset = self.curve.point(s[:-1] + fraction * np.diff(s)) - start
            along = np.clip((offset * chord).sum(1) / square, 0, 1)
            worst = np.maximum(worst, np.linalg.norm(offset - along[:, None] * chord, axis=1))
        return _SAFETY * worst

    def length_at(self, s: Any) -> NDArray:
        """Length along the curve from its start to parameter ``s``."""
        return np.interp(s, self.parameters, self.lengths)

    def first_crossing(
        self, start: float, growth: Callable[..., Any], slope: float, rounding: float = 0.0
    ) -> float | None:
        """Smallest s > ``start`` where ``growth`` turns from negative to positive, or None.

        ``growth(points)`` maps (m, 3) to (m,) and is negative just after ``start``. Between two
        points of the curve it exceeds the larger of their values by at most ``slope`` times the
        deviation of the curve from their chord. What is within ``rounding`` of 0 counts as 0.
        """
        first = int(np.searchsorted(self.parameters, start, side="right"))
        before = -np.inf
        while first < len(self.parameters):
            last = min(first + _CHUNK, len(self.parameters))
            values = growth(self.points[first:last])
            bounds = np.maximum(values, np.concatenate([[before], values[:-1]]))
            bounds += slope * self.deviations[first - 1 : last - 1]
            for k in np.nonzero(bounds > 0)[0]:
                j = first + k
                interval = max(start, self.parameters[j - 1]), self.parameters[j]
                root = self._search(*interval, growth, slope * self.deviations[j - 1], rounding)
                if root is not None:
                    return root
            first, before = last, values[-1]
        return None

    def _search(
        self,
        low: float,
        high: float,
        growth: Callable[..., Any],
        room: float,
        rounding: float,
        depth: int = 0,
    ) -> float | None:
        """First crossing in an interval in which growth exceeds its ends by at most ``room``."""
        s = np.linspace(low, high, _SPLIT + 1)
        values = growth(self.curve.point(s))
        room /= _SPLIT**2
        bounds = np.maximum(values[1:], values[:-1]) + room
        for k in np.nonzero(bounds > 0)[0]:
            if values[k + 1] > 0:
                if values[k] < 0:
                    return self._solve(s[k], s[k + 1], values[k], values[k + 1], growth, rounding)
                if depth < _DEEPEST:
                    return self._search(s[k], s[k + 1], growth, room, rounding, depth + 1)
            elif depth < _DEEPEST and values[k] < 0:
                root = self._search(s[k], s[k + 1], growth, room, rounding, depth + 1)
                if root is not None:
                    return root
        return None

    def _solve(
        self,
        low: float,
        high: float,
        f_low: float,
        f_high: float,
        growth: Callable[..., Any],
        rounding: float,
    ) -> float:
        """Root in a bracket (f_low < 0 < f_high) by the Illinois false position, to rounding."""
        side, s = 0, low
        for _ in range(60):
            previous, s = s, high - f_high * (high - low) / (f_high - f_low)
            f = float(growth(self.curve.point(np.array([s])))[0])
            if abs(f) <= rounding or s == previous or not low < s < high:
                break
            if f > 0:
                high, f_high = s, f
                f_low /= 1 + (side == 1)
                side = 1
            else:
                low, f_low = s, f
                f_high /= 1 + (side == -1)
                side = -1
        return min(max(s, low), high)


def _first_nodes(breaks: Sequence[float] | NDArray) -> NDArray:
    """Evenly spaced parameters, and some inside every piece between ``breaks``."""
    s = np.linspace(0, 1, _FIRST + 1)
    if len(breaks) > 2:
        ends = np.asarray(breaks, float)
        inner = ends[:-1, None] + np.diff(ends)[:, None] * np.arange(_PIECE) / _PIECE
        s = np.union1d(s, inner)
        s = s[np.append(True, np.diff(s) > _SAME)]
        s[-1] = 1.0
    return s
