# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plane polygons with holes, cut into triangles; those of one kind are cut alike.

A cut that was found once is tried on every polygon with as many corners: where all its triangles
keep their sense it is a cut of that one too, since its border is the same. So the search, a cutting
of ears, is run for the first few bodies of a tube only.
"""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .sweeping import flipped, swept

_MANY = 4  # holes from which a polygon is swept instead of losing its ears
_KNOWN: dict = {}  # sizes of the loops -> list of (t, 3) triangles of corners
_ENOUGH = 64  # cuts remembered of polygons of one kind
LEAST_HEIGHT = 5e-5  # mm, of triangles: a lower one would be lost in single precision


def triangulated(
    vertices: NDArray, refs: Sequence[Sequence[int]], sizes: Sequence[Sequence[int]], areas: NDArray
) -> tuple[NDArray, NDArray]:
    """Triangles (t, 3) of vertex numbers of plane faces, and the face (t,) each lies on.

    ``refs``: per face the numbers of its corners, loop after loop, the outer one first and
    anticlockwise from outside, holes clockwise; ``sizes``: per face how many each loop has;
    ``areas``: (f, 3) vectors upright to the faces.
    """
    groups: dict[Any, Any] = {}
    for row, size in enumerate(sizes):
        groups.setdefault(size, []).append(row)
    triangles, which = [np.empty((0, 3), int)], [np.empty(0, int)]
    for size, rows in groups.items():
        corners = np.array([refs[row] for row in rows])
        plans = _plans(vertices[corners], areas[rows])
        for chosen, cut in _cuts(size, plans):
            made = corners[chosen][:, cut]
            triangles.append(made.reshape(-1, 3))
            which.append(np.repeat(np.array(rows)[chosen], len(cut)))
    return np.concatenate(triangles), np.concatenate(which)


def _plans(points: NDArray, normals: NDArray) -> NDArray:
    """Plane coordinates (k, n, 2) of points (k, n, 3) seen against ``normals`` (k, 3)."""
    normals = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    least = np.abs(normals).argmin(1)
    x = np.cross(np.eye(3)[least], normals)
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    y = np.cross(normals, x)
    from_first = points - points[:, :1]
    return np.stack([np.einsum("kni,ki->kn", from_first, axis) for axis in (x, y)], -1)


def _cuts(size: Sequence[int], plans: NDArray) -> Iterator[tuple[NDArray, NDArray]]:
    """(rows, triangles) that together cover all polygons of one kind."""
    if size == (3,):
        yield np.arange(len(plans)), np.array([[0, 1, 2]])
        return
    known, left = _KNOWN.setdefault(size, []), np.arange(len(plans))
    for cut in list(known):
        fits = _fit(plans[left], cut)
        if fits.any():
            yield left[fits], cut
            left = left[~fits]
        if not len(left):
            return
    while len(left):
        cut = cut_of(plans[left[0]], size)
        if len(known) < _ENOUGH:
            known.append(cut)
        fits = _fit(plans[left], cut)
        fits[0] = True
        yield left[fits], cut
        left = left[~fits]


def _fit(plans: NDArray, cut: NDArray) -> NDArray:
    """Whether every triangle of a cut runs anticlockwise and is not too low: (k,) bool."""
    return (_heights(plans[:, cut]) > LEAST_HEIGHT).all(1)


def _heights(corners: NDArray) -> NDArray:
    """Smallest heights (…,) of triangles (…, 3, 2), negative where they run clockwise."""
    sides = corners[..., [1, 2, 0], :] - corners
    twice = sides[..., 0, 0] * sides[..., 1, 1] - sides[..., 0, 1] * sides[..., 1, 0]
    longest = np.sqrt((sides**2).sum(-1).max(-1))
    return twice / np.maximum(longest, 1e-30)


def cut_of(plan: NDArray, size: Sequence[int]) -> NDArray:
    """Triangles (t, 3) of the corners of one polygon, ``plan`` (n, 2), by cutting off ears.

    ``size``: how many corners each loop has; holes are joined to the outer loop first.
    ValueError for a polygon that crosses itself.
    """
    if len(size) > _MANY:
        return swept(plan, size)
    ring = list(range(size[0]))
    start = size[0]
    holes = []
    for count in size[1:]:
        holes.append(list(range(start, start + count)))
        start += count
    while holes:
        ring = _joined(plan, ring, holes)
    triangles = []
    left = np.array(ring)
    while len(left) > 3:
        ear = _best_ear(plan, left)
        triangles.append([left[ear - 1], left[ear], left[(ear + 1) % len(left)]])
        left = np.delete(left, ear)
    found = np.array([*triangles, left])
    if _heights(plan[found]).min() > LEAST_HEIGHT:
        return found
    # corners all but in one line, of which ears leave flat triangles
    starts = np.cumsum([0, *size[:-1]])
    border = {
        (first + k, first + (k + 1) % count)
        for first, count in zip(starts.tolist(), size, strict=True)
        for k in range(count)
    }
    corners = [(float(x), float(y)) for x, y in plan]
    return np.array(flipped(corners, [(a, b, c) for a, b, c in found.tolist()], border))


def _joined(plan: NDArray, ring: Sequence[int], holes: list[list[int]]) -> list[int]:
    """The ring led into its nearest hole and back by the shortest clear way; ``holes`` shrinks."""
    inner = [(k, corner) for k, hole in enumerate(holes) for corner in range(len(hole))]
    ends = np.array([holes[k][corner] for k, corner in inner])
    way = plan[ends][None] - plan[ring][:, None]
    order = np.argsort((way**2).sum(-1), axis=None)
    walls = [ring, *holes]
    starts = np.concatenate([plan[loop] for loop in walls])
    stops = np.concatenate([plan[np.roll(loop, -1)] for loop in walls])
    for flat in order.tolist():
        i, j = divmod(flat, len(ends))
        if _clear(plan[ring[i]], plan[ends[j]], starts, stops):
            k, corner = inner[j]
            hole = holes.pop(k)
            return [*ring[: i + 1], *hole[corner:], *hole[: corner + 1], *ring[i:]]
    raise ValueError("A face with a hole crosses itself.")


def _clear(a: NDArray, b: NDArray, starts: NDArray, stops: NDArray) -> bool:
    """Whether the way from a to b meets no wall but at its own ends."""
    side = _cross(b - a, starts - a), _cross(b - a, stops - a)
    other = _cross(stops - starts, a - starts), _cross(stops - starts, b - starts)
    tiny = 1e-12
    ends = [np.abs(starts - p).max(1) < tiny for p in (a, b)]
    ends += [np.abs(stops - p).max(1) < tiny for p in (a, b)]
    own = ends[0] | ends[1] | ends[2] | ends[3]
    meets = (side[0] * side[1] <= tiny) & (other[0] * other[1] <= tiny)
    return not (meets & ~own).any()


def _best_ear(plan: NDArray, ring: Any) -> int:
    """Place in the ring of the ear with the best shape that holds no other corner."""
    before, here, after = plan[np.roll(ring, 1)], plan[ring], plan[np.roll(ring, -1)]
    corners = np.stack([before, here, after], 1)
    shape = _heights(corners)
    sides = corners[:, [1, 2, 0]] - corners
    shape = shape / np.sqrt((sides**2).sum(-1).max(-1))
    order = np.argsort(-shape)
    for ear in order[shape[order] > 1e-9].tolist():
        inside = np.ones(len(ring), bool)
        for k in range(3):
            inside &= _cross(sides[ear, k], here - corners[ear, k]) > -1e-9
        own = ring[[ear - 1, ear, (ear + 1) % len(ring)]]
        places = plan[own]
        same = (np.abs(here[:, None] - places).max(-1) < 1e-12).any(1)
        if not (inside & ~same).any():
            return ear
    raise ValueError("A face crosses itself, or its corners are all in line.")


def _cross(a: NDArray, b: NDArray) -> NDArray:
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]
