# SPDX-License-Identifier: LGPL-2.1-or-later
"""Does a zigzag of triangles meet itself? Tested as seen along the legs."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from .legs import Legs

# A tube is about h + 0.5 ‖AB‖ high; h is ‖AB‖ / 2.5 by default.
CLEARANCE = 1.2
_SHRINK = 1e-6
_ROWS = 256


def first_overlap(segments: NDArray, legs: "Legs", closed: bool = False) -> tuple | None:
    """First pair (i, j), j ≥ i + 2, of units whose triangles overlap seen along the legs, or None.

    ``segments`` (n + 1, 2, 3): ends of the contact segments; unit i lies between segments i and
    i + 1 with its joint at the second end of segment i. ``legs``: a `legs.Legs`. Along
    parallel legs, units further apart in height than `CLEARANCE` edge lengths pass over each other.
    ``closed``: the last unit is the first one's neighbour.
    """
    start, joint = segments[:-1, 0], segments[:-1, 1]
    triangles = np.stack([start, joint, segments[1:, 1]], 1)
    centres = triangles.mean(1)
    reach = np.linalg.norm(triangles - centres[:, None], axis=-1).max()
    pairs = _close_pairs(centres, 2 * reach)
    if not legs.central:
        height = centres @ legs.at(centres[0])
        edge = np.linalg.norm(joint[0] - start[0])
        pairs = pairs[np.abs(np.diff(height[pairs], axis=1)[:, 0]) < CLEARANCE * edge]
    if closed:
        pairs = pairs[(pairs[:, 0] > 0) | (pairs[:, 1] < len(centres) - 1)]
    if not len(pairs):
        return None
    first, second = triangles[pairs[:, 0]], triangles[pairs[:, 1]]
    hits = np.nonzero(_overlapping(_seen(first, second, legs)))[0]
    return tuple(int(i) for i in pairs[hits[0]]) if len(hits) else None


def _close_pairs(centres: NDArray, distance: float) -> NDArray:
    """Index pairs (i, j ≥ i + 2) with centres closer than ``distance``, ordered by i."""
    found = []
    for low in range(0, len(centres), _ROWS):
        rows = centres[low : low + _ROWS]
        gaps = np.linalg.norm(rows[:, None] - centres[None], axis=-1)
        i, j = np.nonzero(gaps < distance)
        i = i + low
        found.append(np.stack([i, j], 1)[j >= i + 2])
    return np.concatenate(found)


def _seen(first: NDArray, second: NDArray, legs: "Legs") -> NDArray:
    """Both triangles of every pair in a plane across the legs: (pairs, 2, 3, 2)."""
    both = np.stack([first, second], 1)
    centre = both.mean((1, 2))
    axis = legs.at(centre)
    helper = np.where(np.abs(axis[:, :1]) < 0.7, [[1.0, 0, 0]], [[0, 1.0, 0]])
    u = np.cross(axis, helper)
    u /= np.linalg.norm(u, axis=1, keepdims=True)
    v = np.cross(axis, u)
    offset = both - (legs.vector if legs.central else centre[:, None, None])
    plane = np.stack(
        [np.einsum("pijk,pk->pij", offset, u), np.einsum("pijk,pk->pij", offset, v)], -1
    )
    if legs.central:
        plane /= np.einsum("pijk,pk->pij", offset, axis)[..., None]
    middle = plane.mean(2, keepdims=True)
    return middle + (1 - _SHRINK) * (plane - middle)


def _overlapping(pairs: NDArray) -> NDArray:
    """Separating-axis test of triangle pairs (m, 2, 3, 2) → (m,) bool."""
    edges = np.roll(pairs, -1, axis=2) - pairs
    axes = np.stack([-edges[..., 1], edges[..., 0]], -1).reshape(len(pairs), 6, 2)
    shadow = np.einsum("pnk,pijk->pnij", axes, pairs)
    low, high = shadow.min(-1), shadow.max(-1)
    apart = (high[..., 0] <= low[..., 1]) | (high[..., 1] <= low[..., 0])
    return ~apart.any(-1)
