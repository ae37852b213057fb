# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plane polygons in plan view, as Python complex numbers x + i z (mm).

Convex polygons are lists of corners, counter-clockwise, with one tag an edge (the edge that starts
at the corner), so that a panel's edge is still known by its hinge after it was cut back.
"""

from collections.abc import Sequence
from typing import Any

# Two corners nearer than this (mm) are one; a cut that removes less than this is no cut.
TOLERANCE = 1e-3


def dot(a: complex, b: complex) -> float:
    """Scalar product of two plane vectors."""
    return a.real * b.real + a.imag * b.imag


def cross(a: complex, b: complex) -> float:
    """Cross product of two plane vectors: positive if b is to the left of a."""
    return a.real * b.imag - a.imag * b.real


def unit(a: complex) -> complex:
    """Vector of length 1."""
    return a / abs(a)


def area(points: Sequence[complex]) -> float:
    """Signed area of a closed polygon, positive counter-clockwise (mm²)."""
    return sum(cross(a, b) for a, b in zip(points, [*points[1:], points[0]], strict=True)) / 2


def bounding_square(points: Sequence[complex], margin: float) -> list:
    """Square around points, counter-clockwise."""
    xs, zs = [p.real for p in points], [p.imag for p in points]
    low = complex(min(xs) - margin, min(zs) - margin)
    high = complex(max(xs) + margin, max(zs) + margin)
    return [low, complex(high.real, low.imag), high, complex(low.real, high.imag)]


def clip(
    points: Sequence[complex],
    tags: Sequence[Any],
    origin: complex,
    normal: complex,
    tag: str | None,
) -> tuple:
    """Part of a convex polygon where (z − origin)·normal ≥ 0; the new edge gets ``tag``.

    Returns (points, tags); both are empty where nothing is left.
    """
    heights = [dot(p - origin, normal) for p in points]
    if not points or min(heights) > -TOLERANCE:
        return points, tags
    kept, kept_tags = [], []
    n = len(points)
    for i in range(n):
        j = (i + 1) % n
        a, b = heights[i], heights[j]
        inside, next_inside = a >= 0, b >= 0
        if inside:
            kept.append(points[i])
            kept_tags.append(tags[i])
        if inside != next_inside:
            kept.append(points[i] + (points[j] - points[i]) * (a / (a - b)))
            kept_tags.append(tag if inside else tags[i])
    return _merged(kept, kept_tags)


def _merged(points: Sequence[complex], tags: Sequence[Any]) -> tuple[list[complex], list[Any]]:
    # Of two corners that are one, the later keeps its edge; the earlier edge has no length.
    n = len(points)
    keep = [i for i in range(n) if abs(points[(i + 1) % n] - points[i]) > TOLERANCE]
    if len(keep) < 3:
        return [], []
    return [points[i] for i in keep], [tags[i] for i in keep]


def half_planes(
    lines: Sequence[tuple[complex, complex, Any]], points: Sequence[complex], margin: float
) -> tuple:
    """Convex polygon left of all ``lines`` = [(origin, inward normal, tag)], near ``points``."""
    corners, tags = bounding_square(points, margin), [None] * 4
    for origin, normal, tag in lines:
        corners, tags = clip(corners, tags, origin, normal, tag)
    return corners, tags


def intersection(
    first: Sequence[complex], second: Sequence[complex], inset: float = 0.0
) -> list[complex]:
    """Common part of two convex polygons, moved inwards by ``inset`` mm."""
    lines = []
    for polygon in (first, second):
        for a, b in zip(polygon, [*polygon[1:], polygon[0]], strict=True):
            normal = 1j * unit(b - a)
            lines.append((a + inset * normal, normal, None))
    return half_planes(lines, first, 10.0)[0]


def entry(points: Sequence[complex], origin: complex, direction: complex) -> Any:
    """Where a ray enters a convex polygon: (distance, edge index, fraction of the edge) or None."""
    n = len(points)
    far, near, edge = float("inf"), float("-inf"), None
    for i in range(n):
        a, b = points[i], points[(i + 1) % n]
        normal = 1j * (b - a)
        speed, height = dot(direction, normal), dot(origin - a, normal)
        if abs(speed) < 1e-12 * abs(normal):
            if height < 0:
                return None
        elif speed > 0:
            if -height / speed > near:
                near, edge = -height / speed, i
        else:
            far = min(far, -height / speed)
    if edge is None or near > far:
        return None
    a, b = points[edge], points[(edge + 1) % n]
    return near, edge, dot(origin + near * direction - a, b - a) / abs(b - a) ** 2


def rays_distance(p: complex, u: complex, q: complex, v: complex) -> float:
    """Smallest distance of two rays p + s u and q + s v (s ≥ 0, unit vectors) in the plane."""
    d = q - p
    turn = cross(u, v)
    if abs(turn) > 1e-12 and cross(d, v) / turn >= 0 and cross(d, u) / turn >= 0:
        return 0.0
    from_q = abs(d - max(dot(d, u), 0.0) * u)
    from_p = abs(d + max(-dot(d, v), 0.0) * v)
    return min(from_q, from_p)


def free_start(p: complex, u: complex, q: complex, v: complex, distance: float) -> float:
    """Smallest s from which the rays p + s u … and q + s v … stay ``distance`` apart (mm).

    For rays from one point at angle φ: distance / (2 sin(φ/2)) (docs/theory/hinges.md 2).
    """
    d, w = q - p, v - u
    a, b, c = dot(w, w), dot(d, w), dot(d, d) - distance**2
    inner = b * b - a * c
    low = 0.0 if a < 1e-12 or inner < 0 else max(0.0, (-b + inner**0.5) / a)
    if rays_distance(p + low * u, u, q + low * v, v) >= distance - 1e-9:
        return low
    high = 2 * low + 10 * distance
    for _ in range(40):
        middle = (low + high) / 2
        if rays_distance(p + middle * u, u, q + middle * v, v) >= distance:
            high = middle
        else:
            low = middle
    return high
