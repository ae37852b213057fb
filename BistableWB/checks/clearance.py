# SPDX-License-Identifier: LGPL-2.1-or-later
"""Smallest distances between bodies, measured on their meshes (docs/theory/hinges.md 6)."""

from concurrent.futures import ThreadPoolExecutor
from os import cpu_count
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import triangles

if TYPE_CHECKING:
    from .bvh import Scene

# Distances are found to this accuracy (mm): pairs that could only be nearer by less are left out.
ACCURACY = 1e-4
_FIRST_ROUND = 32  # triangle pairs of each pair of bodies that are measured first
_AT_ONCE = 8  # pairs of bodies
_BLOCK = 1 << 15  # pairs of triangles


class Clearances(NamedTuple):
    """``pairs`` (m, 2) of bodies, ``distances`` (m,) mm, and ``points`` (m, 3) mm where that is.

    Pairs further apart than the reach that was asked for are not among them. Distance 0: their
    surfaces meet.
    """

    pairs: np.ndarray
    distances: np.ndarray
    points: np.ndarray


def clearances(scene: "Scene", reach: float, pairs: NDArray | None = None) -> "Clearances":
    """`Clearances` of the bodies of a `Scene` that are nearer than ``reach`` mm.

    ``pairs`` (m, 2): those to look at, all if not given. Copies of a pair are measured once.
    A body wholly inside another one is not seen: `penetration.penetrations` does.
    """
    pairs = scene.body_pairs(reach) if pairs is None else np.asarray(pairs, int).reshape(-1, 2)
    rows, which = scene.distinct(pairs)
    parts = [pairs[rows[k : k + _AT_ONCE]] for k in range(0, len(rows), _AT_ONCE)]
    with ThreadPoolExecutor(cpu_count()) as pool:
        found = list(pool.map(lambda part: _least(scene, part, reach), parts))
    if not found:
        return Clearances(np.zeros((0, 2), int), np.zeros(0), np.zeros((0, 3)))
    distance = np.concatenate([part[0] for part in found])[which]
    points = np.concatenate([part[1] for part in found])[which]
    own = np.zeros(len(pairs), bool)
    own[rows] = True
    points[~own] = np.nan
    near = distance < reach
    return Clearances(pairs[near], distance[near], points[near])


def _least(scene: "Scene", pairs: NDArray, reach: float) -> tuple[NDArray, NDArray]:
    """Distances (m,), at most ``reach``, and points (m, 3) of pairs of bodies."""
    which, first, second = scene.near_triangles(pairs, reach)
    best, where = np.full(len(pairs), float(reach)), np.full((len(pairs), 3), np.nan)
    rows, bound = _facing(scene, first, second, reach)
    order = np.lexsort((bound, which[rows]))
    rows, bound = rows[order], bound[order]
    which, first, second = which[rows], first[rows], second[rows]
    size = _FIRST_ROUND
    while len(which):
        now = _rank(which) < size
        _measure(scene, which[now], first[now], second[now], best, where)
        left = ~now & (bound < best[which] - ACCURACY)
        which, first, second, bound = (column[left] for column in (which, first, second, bound))
        size *= 4
    return best, where


def _facing(
    scene: "Scene", first: NDArray, second: NDArray, reach: float
) -> tuple[NDArray, NDArray]:
    """Rows of the triangle pairs that can be nearest, and their bounds: `triangles.in_front`."""
    kept, bounds = [], []
    for k in range(0, len(first), _BLOCK):
        rows = np.arange(k, min(k + _BLOCK, len(first)))
        bound = np.zeros(len(rows), np.float32)
        for a, b in ((first, second), (second, first)):
            low, high = scene.above(b.take(rows), a.take(rows))
            bound = np.maximum(bound, triangles.in_front(low, high))
            near = np.flatnonzero(bound < reach)
            rows, bound = rows.take(near), bound.take(near)
        kept.append(rows)
        bounds.append(bound)
    if not kept:
        return np.zeros(0, int), np.zeros(0)
    return np.concatenate(kept), np.concatenate(bounds)


def _rank(which: NDArray) -> NDArray:
    """Place of every entry among those of the same pair (``which`` is sorted)."""
    starts = np.flatnonzero(np.diff(which, prepend=-1))
    return np.arange(len(which)) - np.repeat(starts, np.diff(starts, append=len(which)))


def _measure(
    scene: "Scene", which: NDArray, first: NDArray, second: NDArray, best: NDArray, where: NDArray
) -> None:
    found = scene.distances(first, second)
    order = np.lexsort((found, which))
    least = order[np.flatnonzero(np.diff(which[order], prepend=-1))]
    better = least[found[least] < best[which[least]]]
    best[which[better]] = found[better]
    middle = scene.corners[first[better]].mean(1) + scene.corners[second[better]].mean(1)
    where[which[better]] = middle / 2
