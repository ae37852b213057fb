# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners of a curve rounded by a radius (section 5): units cannot follow a kink."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import Refusal
from . import bezier
from .crossing import CurveTable
from .tightness import where

_SHARPEST = np.radians(165.0)
_ROOM = 0.98  # of what two corners leave each other
RADII = 1.2  # ‖AB‖: units of the usual theta follow such a bend within what theta may be


class Rounded:
    """A curve with its kinks replaced by blends of a radius: ``point(s)`` for s in [0, 1].

    ``curve``: ``point(s)``; ``kinks``: the parameters of its kinks, 0 among them where a closed
    curve has one at its seam. Between straight pieces a blend is a circle's arc but for 0.03 % of
    its radius (a cubic), between bent ones it leaves and joins them with their tangents. A closed
    curve starts half way between two corners. `Refusal` where the radius does not fit, naming the
    corner and the largest that does. ``radii`` (k,): what was taken; ``radius`` None: as much as
    fits, ``most`` at most.
    """

    def __init__(
        self, curve: Any, kinks: ArrayLike, radius: float | None = None, most: float = np.inf
    ) -> None:
        self.curve = curve
        self.table = CurveTable(curve, 1e9)
        self.kinks = np.sort(np.asarray(kinks, float))
        self.length = float(self.table.lengths[-1])
        gap = np.linalg.norm(self.table.points[-1] - self.table.points[0])
        self.closed = bool(gap <= 1e-6 * self.length)
        self.turns = np.array([self._turn(s) for s in self.kinks])
        self._check_sharp()
        self.radii = self._radii(radius, most)
        self._pieces(self.radii * np.tan(self.turns / 2))

    def _tangents(self, s: float, step: float = 1e-6) -> tuple[NDArray, NDArray]:
        """Tangents before and after a parameter."""
        before = s if s > 0 else 1.0
        points = np.asarray(self.curve.point(np.array([before - step, before, s, s + step])), float)
        return bezier.normalised(points[1] - points[0]), bezier.normalised(points[3] - points[2])

    def _turn(self, s: float) -> float:
        u, v = self._tangents(s)
        return float(np.arctan2(np.linalg.norm(np.cross(u, v)), u @ v))

    def _check_sharp(self) -> None:
        if not len(self.turns) or self.turns.max() < _SHARPEST:
            return
        k = int(self.turns.argmax())
        raise Refusal(
            "Curve: it turns back on itself by {value:.4g}° at {place}, no radius rounds that",
            cure="open this corner",
            parameter="Points",
            value=float(np.degrees(self.turns[k])),
            place=where(self.curve.point(self.kinks[k])),
        )

    def _rooms(self) -> NDArray:
        """Length of curve that each corner may take on either side: (k,)."""
        at = self.table.length_at(self.kinks)
        ends = np.concatenate([[0.0], at, [self.length]])
        if self.closed:
            ends[0], ends[-1] = at[-1] - self.length, at[0] + self.length
        gaps = np.diff(ends) / 2
        if not self.closed:  # nothing else asks for the ends
            gaps[0], gaps[-1] = 2 * gaps[0], 2 * gaps[-1]
        return _ROOM * np.minimum(gaps[:-1], gaps[1:])

    def _radii(self, radius: float | None, most: float) -> NDArray:
        fitting = self._rooms() / np.tan(self.turns / 2)
        if radius is None:
            return np.minimum(fitting, most)
        if radius > fitting.min():
            k = int(fitting.argmin())
            raise Refusal(
                "{CornerRadius} {value:.4g} mm does not fit at the corner of {turn:.3g}° at "
                "{place}, where {room:.4g} mm at most does",
                cure="lower {CornerRadius}, or move the corners apart",
                parameter="CornerRadius",
                value=float(radius),
                turn=float(np.degrees(self.turns[k])),
                place=where(self.curve.point(self.kinks[k])),
                room=float(fitting[k]),
            )
        return np.full(len(self.kinks), float(radius))

    def _pieces(self, cuts: NDArray) -> None:
        """What the curve is made of: spans of the old curve and cubics, with their lengths."""
        at = self.table.length_at(self.kinks)
        self.parts: list[Any] = []
        lengths: list[float] = []
        here = at[-1] - self.length + cuts[-1] if self.closed else 0.0
        for length, cut in zip(at, cuts, strict=True):
            self._span(here, length - cut, lengths)
            self._blend(length - cut, length + cut, lengths)
            here = length + cut
        if not self.closed:
            self._span(here, self.length, lengths)
        self.bounds = np.concatenate([[0], np.cumsum(lengths)])
        self.total = float(self.bounds[-1])
        # A closed curve starts in the middle of its first span.
        self.offset = lengths[0] / 2 if self.closed else 0.0
        self.breaks = sorted({0.0, 1.0, *(((self.bounds - self.offset) / self.total) % 1).tolist()})

    def _span(self, start: float, end: float, lengths: list[float]) -> None:
        self.parts.append((start, end))
        lengths.append(end - start)

    def _blend(self, start: float, end: float, lengths: list[float]) -> None:
        step = 1e-5
        points = self._old(np.array([start, end]))
        a = bezier.normalised(points[0] - self._old(np.array([start - step * self.length]))[0])
        b = bezier.normalised(self._old(np.array([end + step * self.length]))[0] - points[1])
        turn = np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)
        chord = np.linalg.norm(points[1] - points[0])
        reach = chord * (4 / 3 * np.tan(turn / 4)) / (2 * np.sin(turn / 2)) if turn else chord / 3
        cubic = bezier.Bezier([points[0], points[0] + reach * a, points[1] - reach * b, points[1]])
        fine = np.linalg.norm(np.diff(cubic.point(np.linspace(0, 1, 65)), axis=0), axis=1).sum()
        self.parts.append(cubic)
        lengths.append(fine)

    def _parameter(self, lengths: NDArray) -> NDArray:
        around = np.mod(lengths, self.length) if self.closed else np.clip(lengths, 0, self.length)
        return np.interp(around, self.table.lengths, self.table.parameters)

    def _old(self, lengths: NDArray) -> NDArray:
        return np.asarray(self.curve.point(self._parameter(lengths)), float)

    def point(self, s: NDArray) -> NDArray:
        """Points (…, 3) at ``s`` in [0, 1]."""
        s = np.asarray(s, float)
        place = s.ravel() * self.total + self.offset
        if self.closed:
            place = np.where(place >= self.total, place - self.total, place)
        part = np.clip(np.searchsorted(self.bounds, place, "right") - 1, 0, len(self.parts) - 1)
        points = np.empty((len(place), 3))
        for k in np.unique(part):
            here = part == k
            share = (place[here] - self.bounds[k]) / (self.bounds[k + 1] - self.bounds[k])
            piece = self.parts[k]
            if isinstance(piece, tuple):
                points[here] = self._old(piece[0] + share * (piece[1] - piece[0]))
            else:
                points[here] = piece.point(np.clip(share, 0, 1))
        return points.reshape(*s.shape, 3)
