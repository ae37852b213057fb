# SPDX-License-Identifier: LGPL-2.1-or-later
"""Boundaries of flexible hinges: panels with pockets, and the flexures whose fingers fill them.

Both are prisms whose upright faces are notched where a finger passes, from their upper or lower
edge to the middle of the panel (`flexures`); a pocket and a finger have the same faces, seen from
either side.
"""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from . import polygons
from .drafting import Draft
from .knuckles import at

if TYPE_CHECKING:
    from .boundary import Boundary
    from .flexures import Finger, Strip
    from .parameters import HingeParameters
    from .unit_layout import Plate

_DIGITS = 9  # of a millimetre: corners of a section that are the same


def draw_pocketed(
    draft: Draft,
    plate: "Plate",
    fingers: "Sequence[Finger]",
    parameters: "HingeParameters",
    holes: Mapping[int, Sequence[Sequence[int]]] | None = None,
) -> None:
    """All faces of a panel without knuckles, with a pocket for each of the ``fingers`` in it.

    ``holes``: {−1 or 1: loops} in the lower or upper face, clockwise from outside.
    """
    half = parameters.face_thickness / 2
    heights = plate.height - half, plate.height, plate.height + half
    corners = [[draft.vertex(at(p, heights[k])) for k in (0, 2)] for p in plate.core]
    outlines: tuple[list[Any], list[Any]] = [], []
    core = plate.core
    for k, (a, b) in enumerate(zip(core, [*core[1:], core[0]], strict=True)):
        bites = _bites(fingers, a, b)
        walls, rims = _draw_bites(draft, bites, heights, solid=False)
        here, there = corners[k], corners[(k + 1) % len(core)]
        draft.polygon(here[0], here[1], *walls[1], there[1], there[0], *reversed(walls[0]))
        for side in (0, 1):
            outlines[side].extend([here[side], *rims[side]])
    for side, outline in ((-1, outlines[0]), (1, outlines[1][::-1])):
        draft.plane(draft.ring(outline), *(holes or {}).get(side, []))


def flexure_boundary(strip: "Strip", parameters: "HingeParameters") -> "Boundary":
    """`Boundary` of one `Strip` with its fingers, in the frame of its layout."""
    draft, hinge = Draft(), strip.hinge
    section = outline_of(strip.boxes)
    ends = [
        [draft.vertex(at(hinge.point(s) + n * strip.across, v)) for n, v in section]
        for s in hinge.segments[0]
    ]
    turn = polygons.dot(1j * strip.across, hinge.direction)
    walls, rims, outer = _finger_faces(draft, strip, section, parameters)
    count = len(section)
    for i in range(count):
        j = (i + 1) % count
        chains = walls if i in outer else rims
        along = [chains.get(k, []) for k in (i, j)]
        loop = [ends[0][i], ends[0][j], *along[1], ends[1][j], ends[1][i], *reversed(along[0])]
        draft.polygon(*(loop if turn > 0 else reversed(loop)))
    for end, ring in enumerate(ends):
        draft.polygon(*(ring if (turn > 0) == bool(end) else reversed(ring)))
    return draft.boundary()


def _finger_faces(
    draft: Draft, strip: "Strip", section: Sequence[Sequence[float]], parameters: "HingeParameters"
) -> tuple[dict[int, list[int]], dict[int, list[int]], set[int]]:
    """Draws the fingers of a flexure on the outer faces of its beams.

    Returns vertices along the axis between the ends of a corner of the section, by corner: on the
    beam's outer face, and on the face beside it; and the numbers of the outer faces.
    """
    hinge, half = strip.hinge, parameters.face_thickness / 2
    walls, rims, outer = {}, {}, set()
    for name, fingers in strip.fingers.items():
        middle, side = strip.plates[name]
        away = side * strip.across
        a, b = (hinge.point(s) + parameters.cut_back * away for s in hinge.segments[0])
        forward = polygons.dot(away, 1j * hinge.direction) > 0
        bites = _bites(fingers, *((a, b) if forward else (b, a)))
        heights = middle - half, middle, middle + half
        made = _draw_bites(draft, bites, heights, solid=True)
        corners = [section.index(_rounded(side * parameters.cut_back, v)) for v in heights[::2]]
        for corner, wall, rim in zip(corners, *made, strict=True):
            walls[corner], rims[corner] = (wall, rim) if forward else (wall[::-1], rim[::-1])
        low, high = sorted(corners)
        outer.add(low if high == low + 1 else high)
    return walls, rims, outer


def outline_of(boxes: ArrayLike) -> list[tuple[float, float]]:
    """Corners (n, v) of the union of rectangles (n0, n1, v0, v1), anticlockwise.

    They have no interior in common and hang together; the union has no hole.
    """
    rounded = np.round(np.asarray(boxes, float), _DIGITS)
    xs, ys = np.unique(rounded[:, :2]), np.unique(rounded[:, 2:])
    middles = (xs[1:] + xs[:-1]) / 2, (ys[1:] + ys[:-1]) / 2
    full = np.zeros((len(xs) + 1, len(ys) + 1), bool)
    for n0, n1, v0, v1 in rounded:
        own = (n0 < middles[0]) & (middles[0] < n1)
        full[1:-1, 1:-1] |= own[:, None] & ((v0 < middles[1]) & (middles[1] < v1))
    following = {}
    for i, j in zip(*np.nonzero(full), strict=True):
        corners = (i - 1, j - 1), (i, j - 1), (i, j), (i - 1, j)
        beside = (i, j - 1), (i + 1, j), (i, j + 1), (i - 1, j)
        for k in range(4):
            if not full[beside[k]]:
                following[corners[k]] = corners[(k + 1) % 4]
    ring, at_corner = [], next(iter(following))
    while at_corner in following:
        ring.append(at_corner)
        at_corner = following.pop(at_corner)
    if following:
        raise ValueError("The parts of a flexure do not hang together.")
    return [_rounded(xs[i], ys[j]) for i, j in _bends(ring)]


def _bends(ring: Sequence[tuple[int, int]]) -> list[tuple[int, int]]:
    """Corners of a rectilinear ring at which it turns."""
    around = zip([ring[-1], *ring[:-1]], ring, [*ring[1:], ring[0]], strict=True)
    return [b for a, b, c in around if not (a[0] == b[0] == c[0] or a[1] == b[1] == c[1])]


def _rounded(n: float, v: float) -> tuple[float, float]:
    return round(float(n), _DIGITS), round(float(v), _DIGITS)


def _bites(
    fingers: "Sequence[Finger]", a: complex, b: complex
) -> "list[tuple[tuple[complex, ...], Finger]]":
    """(root, tip, tip, root, upper?) in plan of the fingers across the edge a–b, along it.

    They lie to the left of the edge.
    """
    inward = 1j * polygons.unit(b - a)
    found = []
    for finger in fingers:
        sides = []
        for i, j in ((0, 3), (1, 2)):
            p, q = finger.corners[i], finger.corners[j]
            depth_p, depth_q = (polygons.dot(z - a, inward) for z in (p, q))
            if depth_p * depth_q >= 0:
                break
            root = p + (q - p) * (depth_p / (depth_p - depth_q))
            share = polygons.dot(root - a, b - a) / abs(b - a) ** 2
            if not 0 < share < 1:
                break
            sides.append((share, root, q if depth_q > 0 else p))
        else:
            (first, root, tip), (_, other_root, other_tip) = sorted(sides, key=lambda s: s[0])
            found.append((first, (root, tip, other_tip, other_root), finger))
    return [(points, finger) for _, points, finger in sorted(found, key=lambda f: f[0])]


def _draw_bites(
    draft: Draft,
    bites: "Sequence[tuple[Sequence[complex], Finger]]",
    heights: Sequence[float],
    solid: bool,
) -> tuple[tuple[list[int], list[int]], tuple[list[int], list[int]]]:
    """Faces of pockets (or ``solid`` fingers) left of an edge, and how its borders run there.

    ``heights``: of the panel's lower face, middle and upper face. Returns ((lower, upper) vertices
    along the notched upright face, (lower, upper) vertices along the panel's faces).
    """
    low, middle, high = heights
    rims: Any
    walls: Any
    walls, rims = ([], []), ([], [])

    def face(*corners: int) -> None:
        draft.polygon(*(reversed(corners) if solid else corners))

    for points, finger in bites:
        upper = finger.high > (middle + high) / 2
        deep = [draft.vertex(at(p, middle)) for p in points]
        rim = [draft.vertex(at(p, high if upper else low)) for p in points]
        face(*(deep if upper else deep[::-1]))
        below, above = (deep, rim) if upper else (rim, deep)
        for k, j in pairwise(range(4)):
            face(below[k], above[k], above[j], below[j])
        walls[upper].extend([rim[0], deep[0], deep[3], rim[3]])
        rims[upper].extend(rim)
    return walls, rims
