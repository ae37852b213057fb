# SPDX-License-Identifier: LGPL-2.1-or-later
"""B-splines as files give them, and the smooth curve through points.

A. Piegl, W. Tiller, The NURBS Book, chapters 5 (knot insertion) and 9 (interpolation).
"""

import numpy as np

from .pieces import Array, Line, Piece, Spline


def clamped(degree: int, knots: Array, poles: Array, weights: Array | None = None) -> Spline:
    """The part of any B-spline between its knots ``degree`` and ``-degree - 1``, with its ends.

    Knots are inserted there (Boehm) until each end is ``degree`` + 1 fold, so that the first and
    last pole lie on the curve; a curve that is so already is not touched.
    """
    weights = np.ones(len(poles)) if weights is None else np.asarray(weights, float)
    whole = np.column_stack([np.asarray(poles, float) * weights[:, None], weights])
    knots = np.asarray(knots, float)
    low, high = knots[degree], knots[-degree - 1]
    for value in (low, high):
        while np.count_nonzero(knots == value) < degree:
            knots, whole = _with_knot(degree, knots, whole, value)
    first = int(np.searchsorted(knots, low, side="right")) - degree  # of its last `degree` copies
    last = int(np.searchsorted(knots, high, side="left")) + degree  # after `degree` copies
    poles = whole[first - 1 : last - degree]
    knots = np.concatenate([[low], knots[first:last], [high]])
    rational = np.ptp(poles[:, 3]) > 1e-14 * abs(poles[:, 3]).max()
    return Spline(degree, knots, poles[:, :3] / poles[:, 3:], poles[:, 3] if rational else None)


def _with_knot(degree, knots, poles, value):
    """The same curve with ``value`` once more among its knots."""
    span = int(np.searchsorted(knots, value, side="right")) - 1
    span = min(span, len(poles) - 1) if value == knots[-1] else span
    new = [*poles[: span - degree + 1]]
    for i in range(span - degree + 1, span + 1):
        if i >= len(poles):
            break
        reach = knots[i + degree] - knots[i]
        share = (value - knots[i]) / reach if reach > 0 else 0.0
        new.append((1 - share) * poles[i - 1] + share * poles[i])
    new += [*poles[span:]]
    return np.insert(knots, span + 1, value), np.array(new)


def through(points: Array, tangents: tuple[Array | None, Array | None] = (None, None)) -> Piece:
    """The smooth curve through points (n, 3): a cubic spline with chords as its parameters.

    ``tangents``: directions (3,) at the ends, whose length does not matter; None: those of the
    cubic through the four points next to the end. Two points without tangents give a line.
    """
    points = np.asarray(points, float)
    free = [tangent is None or not np.any(tangent) for tangent in tangents]
    if len(points) == 2 and all(free):
        return Line(points[0], points[1])
    chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
    slopes = _slopes(
        points, chords, [None if f else t for f, t in zip(free, tangents, strict=True)]
    )
    third = chords[:, None] / 3
    inner = np.stack([points[:-1] + third * slopes[:-1], points[1:] - third * slopes[1:]], axis=1)
    at = np.concatenate([[0.0], np.cumsum(chords)])
    # of class C2: the poles at simple knots follow from those of its Béziers
    return _merged(points, inner, at)


def _merged(points, inner, at):
    """One B-spline with double inner knots out of cubic Béziers that meet smoothly."""
    poles = np.concatenate([points[:1], inner.reshape(-1, 3), points[-1:]])
    knots = np.concatenate([np.repeat(at[:1], 4), np.repeat(at[1:-1], 2), np.repeat(at[-1:], 4)])
    return Spline(3, knots, poles)


def _slopes(points, chords, tangents):
    """Derivatives (n, 3) by chord length of the C2 cubic through points: a tridiagonal system."""
    steps = np.diff(points, axis=0) / chords[:, None]
    below, above = np.append(chords[1:], 0.0), np.append(0.0, chords[:-1])
    main = np.concatenate([[2.0], 2 * (chords[1:] + chords[:-1]), [2.0]])
    at = np.concatenate([[0.0], np.cumsum(chords)])
    right = np.zeros_like(points)
    right[1:-1] = 3 * (chords[1:, None] * steps[:-1] + chords[:-1, None] * steps[1:])
    main[0] = main[-1] = 1.0
    right[0] = _end_slope(points[:4], at[:4]) if tangents[0] is None else _unit(tangents[0])
    last = _end_slope(points[:-5:-1], at[:-5:-1])
    right[-1] = last if tangents[1] is None else _unit(tangents[1])
    for k in range(1, len(points)):  # forward elimination: the system is diagonally dominant
        factor = below[k - 1] / main[k - 1]
        main[k] -= factor * above[k - 1]
        right[k] -= factor * right[k - 1]
    right[-1] /= main[-1]
    for k in range(len(points) - 2, -1, -1):
        right[k] = (right[k] - above[k] * right[k + 1]) / main[k]
    return right


def _end_slope(points, at):
    """Derivative, at the first, of the polynomial through up to four points at parameters."""
    powers = (at - at[0])[:, None] ** np.arange(len(at))
    return np.linalg.solve(powers, points)[1]


def _unit(vector):
    return np.asarray(vector, float) / np.linalg.norm(vector)
