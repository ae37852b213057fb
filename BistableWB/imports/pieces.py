# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact pieces of curves, in space: lines, elliptic arcs, and rational B-splines.

What every drawing is made of, whatever the program that drew it. Each kind is closed under affine
maps, so that no transform of a file is ever approximated. Parameters run from 0 to 1, lengths are
those of the file until a reader has mapped them to mm.
"""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

MAX_PIECES = 20_000  # of a drawing: more is no curve for a tube, and minutes of work
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(16)
_NODES, _WEIGHTS = (_NODES + 1) / 2, _WEIGHTS / 2  # on [0, 1]
_PRECISE = 1e-12  # of the length: where bisecting a span changes it by less, it is known
_DEEPEST = 24  # bisections of a span, which only a cusp asks for

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Piece:
    """A piece of a curve: ``at(t)`` → points, ``speed(t)`` → derivatives, both (n, 3), t (n,)."""

    def at(self, t: Array) -> Array:
        """Points (n, 3) at parameters ``t`` (n,) in [0, 1]."""
        raise NotImplementedError

    def speed(self, t: Array) -> Array:
        """Derivatives (n, 3) by ``t``."""
        raise NotImplementedError

    def mapped(self, matrix: Array) -> "Piece":
        """The piece after an affine map: ``matrix`` (4, 4), points are columns."""
        raise NotImplementedError

    def turned(self) -> "Piece":
        """The same piece run through from its end."""
        raise NotImplementedError

    @property
    def bounds(self) -> Array:
        """Parameters between which the piece is smooth, 0 and 1 included."""
        return np.array([0.0, 1.0])

    @cached_property
    def start(self) -> Array:
        """Point (3,) at 0."""
        return self.at(np.zeros(1))[0]

    @cached_property
    def end(self) -> Array:
        """Point (3,) at 1."""
        return self.at(np.ones(1))[0]

    @cached_property
    def length(self) -> float:
        """Arc length."""
        low, high = self.bounds[:-1], self.bounds[1:]
        return _arc_length(self, low, high)

    def direction(self, at_end: bool) -> Array:
        """Unit tangent (3,) at the start or the end, in the sense of the piece."""
        for inset in (0.0, 1e-6, 1e-3, 0.5):
            tangent = self.speed(np.array([1 - inset if at_end else inset]))[0]
            size = float(np.linalg.norm(tangent))
            if size > 1e-12 * (1 + self.length):
                return tangent / size
        return np.zeros(3)


def _arc_length(piece: Piece, low: Array, high: Array) -> float:
    """Length over spans of parameters by Gauss rules, bisected until they agree."""

    def rule(low, high):
        t = low[:, None] + (high - low)[:, None] * _NODES
        speeds = np.linalg.norm(piece.speed(t.ravel()), axis=1).reshape(t.shape)
        return (speeds @ _WEIGHTS) * (high - low)

    total, whole = 0.0, rule(low, high)
    scale = float(whole.sum())
    for _ in range(_DEEPEST):
        middle = (low + high) / 2
        halves = rule(low, middle), rule(middle, high)
        done = np.abs(halves[0] + halves[1] - whole) <= _PRECISE * scale
        total += float((halves[0] + halves[1])[done].sum())
        low, high, whole = (
            np.concatenate([a[~done], b[~done]]) for a, b in ((low, middle), (middle, high), halves)
        )
        if not len(low):
            return total
    return total + float(whole.sum())


@dataclass(frozen=True, eq=False)
class Line(Piece):
    """Straight from ``a`` to ``b``, (3,) each."""

    a: Array
    b: Array

    def at(self, t):
        """See `Piece.at`."""
        return self.a + np.asarray(t)[:, None] * (self.b - self.a)

    def speed(self, t):
        """See `Piece.speed`."""
        return np.repeat((self.b - self.a)[None], len(t), axis=0)

    def mapped(self, matrix):
        """See `Piece.mapped`."""
        return Line(_map(matrix, self.a), _map(matrix, self.b))

    def turned(self):
        """See `Piece.turned`."""
        return Line(self.b, self.a)

    @cached_property
    def start(self):
        """Point (3,) at 0."""
        return self.a

    @cached_property
    def end(self):
        """Point (3,) at 1."""
        return self.b

    @cached_property
    def length(self):
        """Distance of the ends."""
        return math.dist(self.a, self.b)


@dataclass(frozen=True, eq=False)
class Arc(Piece):
    """Elliptic arc: ``centre`` + ``u`` cos φ + ``v`` sin φ, φ from ``first`` to ``last`` (radians).

    u and v (3,) are any two conjugate radii; first > last where it runs the other way.
    """

    centre: Array
    u: Array
    v: Array
    first: float
    last: float

    def _angles(self, t):
        return (self.first + np.asarray(t) * (self.last - self.first))[:, None]

    def at(self, t):
        """See `Piece.at`."""
        angle = self._angles(t)
        return self.centre + np.cos(angle) * self.u + np.sin(angle) * self.v

    def speed(self, t):
        """See `Piece.speed`."""
        angle = self._angles(t)
        return (np.cos(angle) * self.v - np.sin(angle) * self.u) * (self.last - self.first)

    def mapped(self, matrix):
        """See `Piece.mapped`."""
        u, v = matrix[:3, :3] @ self.u, matrix[:3, :3] @ self.v
        return Arc(_map(matrix, self.centre), u, v, self.first, self.last)

    def turned(self):
        """See `Piece.turned`."""
        return Arc(self.centre, self.u, self.v, self.last, self.first)

    @cached_property
    def radii(self) -> tuple[Array, Array]:
        """Principal half axes (3,), the larger first, and turned so that u, v turn alike."""
        vectors, sizes, _ = np.linalg.svd(np.column_stack([self.u, self.v]), full_matrices=False)
        major, minor = vectors[:, 0] * sizes[0], vectors[:, 1] * sizes[1]
        turn = np.cross(self.u, self.v) @ np.cross(major, minor)
        return major, minor if turn >= 0 else -minor

    @property
    def is_circular(self) -> bool:
        """Whether both half axes are of one length."""
        uu, vv, uv = float(self.u @ self.u), float(self.v @ self.v), float(self.u @ self.v)
        return abs(uu - vv) <= 1e-9 * uu and abs(uv) <= 1e-9 * uu

    @cached_property
    def length(self):
        """Arc length."""
        if self.is_circular:
            return math.hypot(*self.u.tolist()) * abs(self.last - self.first)
        return _arc_length(self, *self._spans())

    def _spans(self):
        cuts = np.linspace(0, 1, 2 + int(abs(self.last - self.first) / (math.pi / 4)))
        return cuts[:-1], cuts[1:]


@dataclass(frozen=True, eq=False)
class Spline(Piece):
    """B-spline clamped at both ends, rational where there are ``weights``; Béziers are of one span.

    ``knots`` (n + degree + 1,) rise, each end one ``degree`` + 1 times; ``poles`` (n, 3).
    """

    degree: int
    knots: Array
    poles: Array
    weights: Array | None = None

    @property
    def bounds(self):
        """Parameters of the knots."""
        inner = np.unique(self.knots)
        return (inner - inner[0]) / (inner[-1] - inner[0])

    @cached_property
    def _homogeneous(self):
        weights = np.ones(len(self.poles)) if self.weights is None else self.weights
        return np.column_stack([self.poles * weights[:, None], weights])

    @cached_property
    def _hodograph(self):
        """Poles and knots of the derivative of the homogeneous curve."""
        reach = self.knots[self.degree + 1 : -1] - self.knots[1 : -self.degree - 1]
        safe = np.where(reach > 0, reach, 1.0)[:, None]
        steps = np.diff(self._homogeneous, axis=0) / safe * (reach > 0)[:, None]
        return self.degree * steps, self.knots[1:-1]

    def _own(self, t):
        low, high = self.knots[self.degree], self.knots[-self.degree - 1]
        return low + np.asarray(t, float) * (high - low), high - low

    def at(self, t):
        """See `Piece.at`."""
        x, _ = self._own(t)
        whole = _de_boor(self.degree, self.knots, self._homogeneous, x)
        return whole[:, :3] / whole[:, 3:]

    def speed(self, t):
        """See `Piece.speed`."""
        x, span = self._own(t)
        whole = _de_boor(self.degree, self.knots, self._homogeneous, x)
        slope = _de_boor(self.degree - 1, self._hodograph[1], self._hodograph[0], x)
        points = whole[:, :3] / whole[:, 3:]
        return span * (slope[:, :3] - points * slope[:, 3:]) / whole[:, 3:]

    def direction(self, at_end):
        """See `Piece.direction`: from the first pole to the next that lies elsewhere."""
        poles = self.poles[::-1] if at_end else self.poles
        for pole in poles[1:]:
            size = math.dist(pole, poles[0])
            if size > 1e-9:
                return (poles[0] - pole if at_end else pole - poles[0]) / size
        return np.zeros(3)

    def mapped(self, matrix):
        """See `Piece.mapped`."""
        return Spline(self.degree, self.knots, _map(matrix, self.poles), self.weights)

    def turned(self):
        """See `Piece.turned`."""
        weights = None if self.weights is None else self.weights[::-1]
        knots = self.knots[0] + self.knots[-1] - self.knots[::-1]
        return Spline(self.degree, knots, self.poles[::-1], weights)

    @cached_property
    def start(self):
        """Point (3,) at 0."""
        return self.poles[0]

    @cached_property
    def end(self):
        """Point (3,) at 1."""
        return self.poles[-1]


def _de_boor(degree: int, knots: Array, poles: Array, x: Array) -> Array:
    """Values (n, m) of a B-spline with ``poles`` (k, m) at ``x`` (n,)."""
    span = np.clip(np.searchsorted(knots, x, side="right") - 1, degree, len(poles) - 1)
    local = poles[span[:, None] + np.arange(-degree, 1)]  # (n, degree + 1, m)
    for level in range(1, degree + 1):
        for k in range(degree, level - 1, -1):
            low = knots[span + k - degree]
            reach = knots[span + k + 1 - level] - low
            share = np.where(reach > 0, (x - low) / np.where(reach > 0, reach, 1), 0.0)[:, None]
            local[:, k] = (1 - share) * local[:, k - 1] + share * local[:, k]
    return local[:, degree]


def bezier(poles: Array) -> Piece:
    """A Bézier curve by its control points (n, 2 or 3); a line where there are two."""
    points = np.zeros((len(poles), 3))
    points[:, : np.shape(poles)[1]] = poles
    if len(points) == 2:
        return Line(points[0], points[1])
    knots = np.repeat([0.0, 1.0], len(points))
    return Spline(len(points) - 1, knots, points)


def _map(matrix: Array, points: Array) -> Array:
    return points @ matrix[:3, :3].T + matrix[:3, 3]
