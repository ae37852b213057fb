# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bézier curves of any degree, evaluated in batches, stable for many control points."""

from collections.abc import Sequence
from math import comb
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import Refusal

if TYPE_CHECKING:
    from .curve import Curve


class Bezier:
    """An open Bézier curve by its control points (section 3.1 of the paper).

    ``points``: (n, 2) or (n, 3) control points, n ≥ 2, any unit of length (2D gets z = 0).
    ``point``, ``tangent`` and ``curvature`` take s in [0, 1], a scalar or an array of any shape.
    The Bernstein sum has only positive terms in [0, 1], so it is stable for any n.
    ValueError for fewer than two points, values that are not finite, or neighbours that coincide.
    """

    def __init__(self, points: NDArray | Sequence[Any]) -> None:
        points = _as_points(points)
        self.points = points
        degree = len(points) - 1
        self._levels = [points - points[0]]
        for k in range(min(2, degree)):
            self._levels.append((degree - k) * np.diff(self._levels[-1], axis=0))

    @property
    def bend(self) -> float:
        """Bound on the length of the second derivative by s: its longest control vector."""
        if len(self._levels) < 3:
            return 0.0
        return float(np.linalg.norm(self._levels[2], axis=1).max())

    def point(self, s: NDArray | float) -> NDArray:
        """Points at s: shape (…, 3). Far from the origin nothing of their accuracy is lost."""
        return self.points[0] + _bernstein(self._levels[0], s)

    def derivative(self, s: NDArray | float, order: int = 1) -> NDArray:
        """First or second derivative by s: shape (…, 3)."""
        if order < len(self._levels):
            return _bernstein(self._levels[order], s)
        return np.zeros((*np.shape(s), 3))

    def tangent(self, s: NDArray) -> NDArray:
        """Unit tangents at s: (…, 3). Where the speed vanishes, the limit along the curve."""
        return unit_tangent(self, s)

    def curvature(self, s: NDArray | float) -> NDArray | float:
        """Curvature 1/radius at s, shape of s; infinite at a cusp."""
        return curvature(self.derivative(s, 1), self.derivative(s, 2))


def unit_tangent(curve: "Curve", s: NDArray, step: float = 1e-6) -> NDArray:
    """Unit tangents (…, 3) of a curve with ``point`` and, if it has one, ``derivative``.

    Without a derivative, and where it vanishes (coincident end control points), the direction is
    taken from a short chord.
    """
    s = np.asarray(s, float)
    chord = curve.point(np.minimum(s + step, 1)) - curve.point(np.maximum(s - step, 0))
    if not hasattr(curve, "derivative"):
        return normalised(chord)
    speed = curve.derivative(s)
    tiny = 1e-6 * np.linalg.norm(chord, axis=-1, keepdims=True) / (2 * step)
    vanishing = np.linalg.norm(speed, axis=-1, keepdims=True) <= tiny
    return normalised(np.where(vanishing, chord, speed))


def normalised(vectors: NDArray) -> NDArray:
    """Vectors of length one along the last axis; zero stays zero."""
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(length > 0, length, 1)


def curvature(first: NDArray, second: NDArray) -> Any:
    """|r' × r''| / |r'|³ of first and second derivatives (…, 3); infinite where r' vanishes."""
    speed = np.linalg.norm(first, axis=-1)
    turn = np.linalg.norm(np.cross(first, second), axis=-1)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(speed > 0, turn / speed**3, np.inf)[()]


def _as_points(points: ArrayLike) -> NDArray:
    points = np.array(points, float)
    if points.ndim != 2 or points.shape[1] not in (2, 3) or len(points) < 2:
        raise Refusal(
            "{Points}: a curve needs at least two control points of 2 or 3 coordinates each; add "
            "control points.",
            parameter="Points",
        )
    bad = ~np.isfinite(points).all(axis=1)
    if bad.any():
        raise Refusal(
            "{Points}: control point {number} has a coordinate that is not a finite number; give "
            "it numbers in mm.",
            parameter="Points",
            number=int(np.argmax(bad)) + 1,
        )
    if points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points))])
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    if steps.min() <= 1e-9 * steps.max():
        k = int(np.argmin(steps)) + 1
        raise Refusal(
            "{Points}: control points {number} and {following} coincide; move one of them or "
            "remove it.",
            parameter="Points",
            number=k,
            following=k + 1,
        )
    return points


_BINOMIALS: dict = {}


def _bernstein(points: NDArray, s: NDArray | float) -> NDArray:
    s = np.asarray(s, float)
    degree = len(points) - 1
    if degree not in _BINOMIALS:
        exponents = np.arange(degree + 1)
        binomials = np.array([comb(degree, int(i)) for i in exponents], float)
        _BINOMIALS[degree] = exponents, binomials, exponents[::-1]
    up, binomials, down = _BINOMIALS[degree]
    column = s[..., None]
    return (binomials * column**up * (1 - column) ** down) @ points
