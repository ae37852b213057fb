# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact distances and intersections of many pairs of triangles at once. Lengths in mm."""

import numpy as np
from numpy.typing import NDArray

_CHUNK = 8192  # pairs at a time, so that intermediate results stay in the processor's cache
_TINY = 1e-30
_LEVEL = 1e-4  # mm from a plane that count as in it
_NEXT = [1, 2, 0]


def distances(first: NDArray, second: NDArray) -> NDArray:
    """Smallest distance of each pair of triangles: (n, 3, 3), (n, 3, 3) → (n,). 0 if they meet."""
    found = np.empty(len(first))
    for k in range(0, len(first), _CHUNK):
        part = slice(k, k + _CHUNK)
        found[part] = _distances(first[part], second[part])
    return found


def planes(corners: NDArray) -> tuple:
    """Unit normals (t, 3) and heights (t,) of the planes of triangles; zeros for slivers."""
    normal = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normal, axis=1)
    normal /= np.where(length > 1e-12, length, np.inf)[:, None]
    return normal, dot(normal, corners[:, 0])


def in_front(low: NDArray, high: NDArray) -> NDArray:
    """How far triangles lie in front of planes, at least 0; inf for those behind: (n,).

    ``low``, ``high`` (n,): their least and largest heights above them. Where two solids are
    nearest, some triangles there see each other's fronts; triangles in the plane itself, of bodies
    that touch, count as in front.
    """
    return np.where(high > -_LEVEL, np.maximum(low, 0), np.inf)


def least_of_three(values: NDArray) -> NDArray:
    """Minimum along an axis of three (much faster than `numpy.min` for so short an axis)."""
    return np.minimum(np.minimum(values[:, 0], values[:, 1]), values[:, 2])


def most_of_three(values: NDArray) -> NDArray:
    """Maximum along an axis of three."""
    return np.maximum(np.maximum(values[:, 0], values[:, 1]), values[:, 2])


def cross(a: NDArray, b: NDArray) -> NDArray:
    """Cross products along the last axis (`numpy.cross` is several times slower)."""
    ax, ay, az = a[..., 0], a[..., 1], a[..., 2]
    bx, by, bz = b[..., 0], b[..., 1], b[..., 2]
    found = np.empty(np.broadcast_shapes(a.shape, b.shape))
    np.subtract(ay * bz, az * by, out=found[..., 0])
    np.subtract(az * bx, ax * bz, out=found[..., 1])
    np.subtract(ax * by, ay * bx, out=found[..., 2])
    return found


def dot(a: NDArray, b: NDArray) -> NDArray:
    """Scalar products along the last axis."""
    if a.ndim == b.ndim == 2:
        return a[:, 0] * b[:, 0] + a[:, 1] * b[:, 1] + a[:, 2] * b[:, 2]
    return np.einsum("...i,...i->...", a, b)


def _distances(p: NDArray, q: NDArray) -> NDArray:
    square = np.minimum(_corners_to_triangles(q, p), _corners_to_triangles(p, q))
    square = np.minimum(square, _edges_to_edges(p, q))
    near = np.flatnonzero(square < (np.ptp(p, axis=1).max() + np.ptp(q, axis=1).max()) ** 2)
    meet = edges_through(p[near], q[near])[0].any(1) | edges_through(q[near], p[near])[0].any(1)
    square[near[meet]] = 0
    return np.sqrt(square)


def _corners_to_triangles(points: NDArray, triangle: NDArray) -> NDArray:
    """Smallest squared distance of three points to the inside of a triangle; inf if beside it."""
    u, v = triangle[:, 1] - triangle[:, 0], triangle[:, 2] - triangle[:, 0]
    normal = cross(u, v)
    area = dot(normal, normal) + _TINY
    w = points - triangle[:, :1]
    b = dot(cross(w, v[:, None]), normal[:, None])
    c = dot(cross(u[:, None], w), normal[:, None])
    inside = (b >= 0) & (c >= 0) & (b + c <= area[:, None])
    height = dot(w, normal[:, None])
    return np.where(inside, height * height / area[:, None], np.inf).min(1)


def _edges_to_edges(p: NDArray, q: NDArray) -> NDArray:
    """Smallest squared distance of the three edges of either triangle."""
    d1, d2 = p[:, _NEXT] - p, q[:, _NEXT] - q
    d1, d2 = d1[:, :, None], d2[:, None, :]
    r = p[:, :, None] - q[:, None, :]
    a, e = dot(d1, d1) + _TINY, dot(d2, d2) + _TINY
    b, c, f = dot(d1, d2), dot(d1, r), dot(d2, r)
    denominator = a * e - b * b
    s = np.clip((b * f - c * e) / np.where(denominator > 1e-12 * a * e, denominator, np.inf), 0, 1)
    t = np.clip((b * s + f) / e, 0, 1)
    s = np.clip((b * t - c) / a, 0, 1)
    gap = r + s[..., None] * d1 - t[..., None] * d2
    return dot(gap, gap).min((1, 2))


def edges_through(p: NDArray, q: NDArray) -> tuple:
    """Where the edges of triangles ``p`` pass through triangles ``q``.

    Returns hit (n, 3), the fraction along the edge (n, 3), and whether the edge goes in there,
    against q's normal (n, 3). Edges in q's plane do not pass through it.
    """
    u, v = q[:, 1] - q[:, 0], q[:, 2] - q[:, 0]
    normal = cross(u, v)
    height = dot(p - q[:, :1], normal[:, None])
    after = height[:, _NEXT]
    crosses = (height > 0) != (after > 0)
    step = height - after
    share = height / np.where(crosses & (step != 0), step, 1)
    along = p[:, _NEXT] - p
    w = p + share[..., None] * along - q[:, :1]
    area = dot(normal, normal)[:, None]
    b = dot(cross(w, v[:, None]), normal[:, None])
    c = dot(cross(u[:, None], w), normal[:, None])
    hit = crosses & (b >= 0) & (c >= 0) & (b + c <= area)
    return hit, share, height > 0


def points_to_triangles(points: NDArray, triangles: NDArray) -> NDArray:
    """Squared distance of each point to its triangle: (n, 3), (n, 3, 3) → (n,)."""
    inside = _corners_to_triangles(points[:, None], triangles)
    along = triangles[:, _NEXT] - triangles
    w = points[:, None] - triangles
    t = np.clip(dot(w, along) / (dot(along, along) + _TINY), 0, 1)
    gap = w - t[..., None] * along
    return np.minimum(inside, dot(gap, gap).min(1))
