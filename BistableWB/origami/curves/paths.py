# SPDX-License-Identifier: LGPL-2.1-or-later
"""A curve by its length: what a steered zigzag is drawn towards."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from . import bezier

if TYPE_CHECKING:
    from .crossing import CurveTable

_NODES = 48  # an edge length
_LEAST, _MOST = 400, 40_000
_ROUNDS = 3


class Path:
    """Points and unit tangents of a curve by length along it, from a `crossing.CurveTable`.

    ``closed``: lengths go round and round, else they end at 0 and ``length``. Cubic between nodes.
    """

    def __init__(self, table: "CurveTable", edge_length: float, closed: bool = False) -> None:
        self.length = float(table.lengths[-1])
        count = int(np.clip(_NODES * self.length / edge_length, _LEAST, _MOST))
        self.step = self.length / count
        nodes = np.linspace(0, self.length, count + 1)
        self.parameters = np.interp(nodes, table.lengths, table.parameters)
        self.points = np.asarray(table.curve.point(self.parameters), float)
        if closed:
            self.points[-1] = self.points[0]
            around = np.concatenate([self.points[-3:-1], self.points, self.points[1:3]])
            self.slopes = np.gradient(around, axis=0)[2:-2]
        else:
            self.slopes = np.gradient(self.points, axis=0, edge_order=2)
        self.closed = closed

    def at(self, lengths: NDArray) -> tuple:
        """Points and unit tangents (m, 3) at lengths (m,)."""
        place = self._within(lengths) / self.step
        k = np.minimum(place.astype(int), len(self.points) - 2)
        u = (place - k)[:, None]
        p, q, v, w = self.points[k], self.points[k + 1], self.slopes[k], self.slopes[k + 1]
        bend, twist = 3 * (q - p) - 2 * v - w, 2 * (p - q) + v + w
        points = p + u * (v + u * (bend + u * twist))
        return points, bezier.normalised(v + u * (2 * bend + 3 * u * twist))

    def parameters_at(self, lengths: NDArray) -> NDArray:
        """Parameters (m,) of the curve at lengths."""
        nodes = np.arange(len(self.parameters)) * self.step
        return np.interp(self._within(lengths), nodes, self.parameters)

    def nearest(self, points: NDArray, lengths: NDArray) -> NDArray:
        """Lengths (m,) of the feet of points (m, 3), from guesses near them."""
        for _ in range(_ROUNDS):
            feet, tangents = self.at(lengths)
            ahead = np.clip(((points - feet) * tangents).sum(1), -self.length / 4, self.length / 4)
            lengths = lengths + ahead
            if not self.closed:
                lengths = np.clip(lengths, 0, self.length)
        return lengths

    def _within(self, lengths: NDArray) -> NDArray:
        if self.closed:
            return np.mod(lengths, self.length)
        return np.clip(lengths, 0, self.length)
