# SPDX-License-Identifier: LGPL-2.1-or-later
"""How deep bodies run into each other, measured on their meshes.

Depth of an overlap: how far the surface of one body lies below the surface of the other, at most.
It is 0 for bodies that only touch. Where the surfaces cross, the edges of one body pass through the
triangles of the other; the parts of them that lie inside are followed, and their depth measured.
"""

from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..origami.meshes import half_edges
from . import triangles
from .triangles import dot

if TYPE_CHECKING:
    from ..origami.meshes import Mesh
    from .bvh import Scene

_SAMPLES = np.array([0.02, 0.25, 0.5, 0.75, 0.98])  # of a part of an edge that lies inside
_KNOWN = 400  # crossings that bound the depth of a point
_BATCH = 24  # points whose depths are measured at a time
_TOUCH = 1e-6  # mm within which bounds of triangles that may cross are looked for


class Penetrations(NamedTuple):
    """``pairs`` (m, 2) of bodies that overlap, ``depths`` (m,) mm, and ``points`` (m, 3) where."""

    pairs: np.ndarray
    depths: np.ndarray
    points: np.ndarray


def penetrations(scene: "Scene", pairs: NDArray | None = None) -> "Penetrations":
    """`Penetrations` of the bodies of a `Scene`; ``pairs`` (m, 2): those to look at, or all."""
    pairs = scene.body_pairs(_TOUCH) if pairs is None else np.asarray(pairs, int).reshape(-1, 2)
    rows, which = scene.distinct(pairs)
    near = pairs[rows]
    hits = _grouped(_hits(scene, near), len(near))
    depths, points = np.zeros(len(near)), np.full((len(near), 3), np.nan)
    for k, (a, b) in enumerate(near.tolist()):
        depths[k], points[k] = _overlap(scene, hits[k], a, b)
    found = np.flatnonzero(depths[which] > 0)
    which = which[found]
    return Penetrations(
        pairs[found], depths[which], scene.like(pairs[found], near[which], points[which])
    )


def _overlap(scene: "Scene", hits: "tuple[_Hits, _Hits]", a: int, b: int) -> tuple[float, NDArray]:
    """(depth, point) of the overlap of bodies a and b, ``hits`` `_Hits` of both their edges."""
    inside = [
        _inside(scene, one, body, other)
        for one, body, other in zip(hits, (a, b), (b, a), strict=True)
    ]
    if not len(inside[0][1]) and not len(inside[1][1]):
        depths = [_swallowed(scene, a, b), _swallowed(scene, b, a)]
    else:
        depths = [
            _deepest(scene.meshes[other], points, crossings)
            for (points, crossings), other in zip(inside, (b, a), strict=True)
        ]
    return max(depths, key=lambda entry: entry[0])


class _Hits(NamedTuple):
    """Edges through triangles: pair, side of the edge's body, its half-edge, fraction, way in."""

    pair: np.ndarray
    side: np.ndarray
    edge: np.ndarray
    share: np.ndarray
    enters: np.ndarray


def _hits(scene: "Scene", pairs: NDArray) -> _Hits:
    which, first, second = scene.near_triangles(pairs, _TOUCH)
    found = []
    for k in range(0, len(which), 1 << 15):
        part = slice(k, k + (1 << 15))
        for side, one, other in ((0, first[part], second[part]), (1, second[part], first[part])):
            rows = np.flatnonzero(scene.reaches(one, other)[0])
            one, other = one.take(rows), other.take(rows)
            corners = scene.corners.take(one, 0), scene.corners.take(other, 0)
            hit, share, enters = triangles.edges_through(*corners)
            row, corner = np.nonzero(hit)
            edge = 3 * one[row] + corner
            found.append((which[part][rows][row], np.full(len(row), side), edge, share[hit],
                          enters[hit]))  # fmt: skip
    if not found:
        return _Hits(*(np.zeros(0, t) for t in (int, int, int, float, bool)))
    return _Hits(*(np.concatenate(column) for column in zip(*found, strict=True)))


def _grouped(hits: _Hits, count: int) -> list[tuple[_Hits, _Hits]]:
    """`_Hits` of either side of every pair: count times two."""
    key = 2 * hits.pair + hits.side
    order = np.argsort(key, kind="stable")
    ends = np.searchsorted(key[order], np.arange(2 * count + 1)).tolist()
    hits = _Hits(*(column[order] for column in hits))
    parts = [_Hits(*(c[i:j] for c in hits)) for i, j in pairwise(ends)]
    return list(zip(parts[::2], parts[1::2], strict=True))


def _inside(scene: "Scene", hits: _Hits, body: int, outer: int) -> tuple[NDArray, NDArray]:
    """Points (n, 3) of a body's edges that lie inside the other one, and where edges enter it."""
    mesh, other = scene.meshes[body], scene.meshes[outer]
    local = hits.edge - 3 * scene.offset[body]
    ends = np.stack([mesh.triangles[local // 3, (local + k) % 3] for k in (0, 1)], 1)
    rows = np.flatnonzero(ends[:, 0] < ends[:, 1])  # every edge is met twice, once each way
    local, ends = local[rows], ends[rows]
    if not len(rows):
        return np.zeros((0, 3)), np.zeros((0, 3))
    share, enters = hits.share[rows], hits.enters[rows]
    order = np.lexsort((share, local))
    local, ends, share, enters = local[order], ends[order], share[order], enters[order]
    first = np.diff(local, prepend=-1) > 0
    last = np.append(first[1:], True)
    # The part before every crossing that leads out, and after the last one that leads in.
    before = np.where(first, 0.0, np.roll(share, 1))
    out, on = ~enters, last & enters
    low = np.concatenate([before[out], share[on]])
    high = np.concatenate([share[out], np.ones(on.sum())])
    tails = np.concatenate([ends[out], ends[on]])
    start, end = mesh.vertices[tails[:, 0]], mesh.vertices[tails[:, 1]]
    shares = low[:, None] + (high - low)[:, None] * _SAMPLES
    samples = start[:, None] + shares[..., None] * (end - start)[:, None]
    seeds = np.unique(np.concatenate([ends[first & ~enters][:, 0], ends[on][:, 1]]))
    seeds = seeds[_winding(other, mesh.vertices[seeds]) > 0.5]
    corners = mesh.vertices[_connected(mesh, seeds, ends)]
    crossings = mesh.vertices[ends[:, 0]] * (1 - share[:, None])
    crossings = crossings + mesh.vertices[ends[:, 1]] * share[:, None]
    return np.concatenate([samples.reshape(-1, 3), corners]), crossings


def _connected(mesh: "Mesh", seeds: NDArray, crossed: NDArray) -> NDArray:
    """Vertices that hang together with ``seeds`` by edges that are not ``crossed``."""
    reached = np.zeros(len(mesh.vertices), bool)
    reached[seeds] = True
    if not reached.any():
        return np.zeros(0, int)
    edges = half_edges(mesh.triangles)
    edges = edges[edges[:, 0] < edges[:, 1]]
    count = len(mesh.vertices)
    edges = edges[~np.isin(edges @ [count, 1], crossed @ [count, 1])]
    while True:
        touched = reached[edges[:, 0]] != reached[edges[:, 1]]
        if not touched.any():
            return np.flatnonzero(reached)
        reached[edges[touched].ravel()] = True


def _deepest(mesh: "Mesh", points: NDArray, crossings: NDArray) -> tuple[float, NDArray]:
    """(depth, point): the largest distance from a mesh of ``points`` inside it."""
    if not len(points) or not len(crossings):
        return 0.0, np.full(3, np.nan)
    # No point is deeper than its distance to the nearest crossing.
    known = crossings[:: 1 + len(crossings) // _KNOWN]
    square = dot(points, points)[:, None] + dot(known, known) - 2 * points @ known.T
    bound = np.sqrt(np.maximum(square.min(1), 0)) + _TOUCH
    corners = mesh.corners
    reach = bound.max()
    near = (corners.max(1) >= points.min(0) - reach) & (corners.min(1) <= points.max(0) + reach)
    corners = corners[near.all(1)]
    deepest, where = 0.0, points[0]
    order = np.argsort(-bound)
    for k in range(0, len(order), _BATCH):
        batch = order[k : k + _BATCH]
        if bound[batch[0]] <= deepest or not len(corners):
            break
        depths = _depths(points[batch], bound[batch], corners)
        for row in np.argsort(-depths):
            if depths[row] <= deepest:
                break
            # Rounding may have taken a point for an inner one.
            point = points[batch[row]]
            if _winding(mesh, point[None])[0] > 0.5:
                deepest, where = float(depths[row]), point
    return deepest, where


def _depths(points: NDArray, bounds: NDArray, corners: NDArray) -> NDArray:
    """Distances (n,) of points from triangles, those of the latter that are within ``bounds``."""
    beside = np.maximum(corners.min(1) - points[:, None], points[:, None] - corners.max(1))
    near = (np.maximum(beside, 0) ** 2).sum(-1) <= bounds[:, None] ** 2 + 1e-12
    rows, columns = np.nonzero(near)
    square = np.full(len(points), np.inf)
    np.minimum.at(square, rows, triangles.points_to_triangles(points[rows], corners[columns]))
    return np.where(np.isfinite(square), np.sqrt(square), 0.0)


def _swallowed(scene: "Scene", inner: int, outer: int) -> tuple[float, NDArray]:
    """(depth, point) where one body lies inside another without meeting its surface."""
    small, large = scene.meshes[inner], scene.meshes[outer]
    box, around = scene.boxes[[inner, outer]]
    if (box[0] < around[0]).any() or (box[1] > around[1]).any():
        return 0.0, np.full(3, np.nan)
    point = small.vertices[0]
    if _winding(large, point[None])[0] < 0.5:
        return 0.0, np.full(3, np.nan)
    return float(np.min(around[1] - around[0])), point


def _winding(mesh: "Mesh", points: NDArray) -> NDArray:
    """Winding numbers (n,) of a mesh about points (n, 3): 1 inside, 0 outside."""
    corners, found = mesh.corners, np.empty(len(points))
    for k, point in enumerate(points):
        a, b, c = np.moveaxis(corners - point, 1, 0)
        la, lb, lc = (np.sqrt(dot(v, v)) for v in (a, b, c))
        above = dot(a, triangles.cross(b, c))
        below = la * lb * lc + dot(a, b) * lc
        below += dot(b, c) * la + dot(c, a) * lb
        found[k] = np.arctan2(above, below).sum() / (2 * np.pi)
    return found
