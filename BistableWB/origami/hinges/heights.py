# SPDX-License-Identifier: LGPL-2.1-or-later
"""How high a panel or a link reaches over every point of its plan: two rasters, bottom and top.

From the layout alone, no mesh: a panel is its core and tabs as slabs and its barrels as cylinders
(theory/hinges.md 2). In every column of a panel or a link lies one stretch of plastic.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import sqrt
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import polygons
from .link_section import link_section
from .unit_layout import Hinge, Link, Plate, tab_points

if TYPE_CHECKING:
    from .parameters import HingeParameters

Slab = tuple[Sequence[complex], float, float]  # corners, bottom, top
Barrel = tuple[complex, complex, float]  # start and end in plan, height of the axis
# x (columns,), z (rows, 1) → bottom and top over them, numbers or arrays
Ends = Callable[[NDArray, NDArray], tuple[Any, Any]]

PIXEL = 0.2  # mm
_SURE = 0.05  # mm by which bodies on the way stay clear of a stand-off, besides the play
_TOGETHER = 32  # spots that are looked at as one, by their box
_AT_ONCE = 100_000  # spots that are moved
_UPRIGHT = 1e-12  # cosine below which an edge runs along x
_STEEP = 0.5  # of a barrel's radius: beyond, its underside carries itself (60° from the vertical)


@dataclass(frozen=True, eq=False)
class Heights:
    """``low`` and ``high`` (rows, columns) mm, +∞ and −∞ where there is nothing.

    ``corner``: plan point x + i z of the first pixel's first corner; rows run along z.
    """

    low: NDArray
    high: NDArray
    corner: complex

    @cached_property
    def box(self) -> tuple[NDArray, NDArray]:
        """Lowest and highest coordinates (3,) of where there may be something."""
        rows, columns = self.low.shape
        low, high = self.low.min(), self.high.max()  # ±∞ where there is nothing at all
        start = np.array([self.corner.real, low, self.corner.imag])
        return start, start + np.array([columns * PIXEL, high - low, rows * PIXEL])

    def may_lie_over(self, x: NDArray, z: NDArray, above: float) -> bool:
        """Whether something higher than ``above`` may lie over plan points, by its box."""
        low, high = self.box
        return bool(
            high[1] > above
            and x.max() > low[0] and x.min() < high[0] and z.max() > low[2] and z.min() < high[2]
        )  # fmt: skip

    def at(self, x: NDArray, z: NDArray) -> tuple[NDArray, NDArray]:
        """Bottom and top (n,) at plan points."""
        column = np.floor((x - self.corner.real) / PIXEL).astype(int)
        row = np.floor((z - self.corner.imag) / PIXEL).astype(int)
        rows, columns = self.low.shape
        out = (row < 0) | (row >= rows) | (column < 0) | (column >= columns)
        row[out] = column[out] = 0
        low, high = self.low[row, column], self.high[row, column]
        low[out], high[out] = np.inf, -np.inf
        return low, high


def heights_of(
    body: Plate | Link, parameters: "HingeParameters", grown: float = 0.0, flat: bool = False
) -> Heights:
    """`Heights` of a `Plate` or `Link`, every part ``grown`` sideways by so many mm.

    ``flat``: without what of barrels is too steep to want support below.
    """
    slabs, barrels = _link(body, parameters) if isinstance(body, Link) else _plate(body, parameters)
    across = parameters.radius * (_STEEP if flat else 1.0)
    boxes = [_along(start, end, across) for start, end, _ in barrels]
    points = [p for corners, *_ in slabs for p in corners] + [p for box in boxes for p in box]
    low = complex(min(p.real for p in points), min(p.imag for p in points))
    high = complex(max(p.real for p in points), max(p.imag for p in points))
    corner = low - (1 + 1j) * (grown + PIXEL)
    size = (high - corner) + (1 + 1j) * (grown + PIXEL)
    shape = int(size.imag / PIXEL) + 1, int(size.real / PIXEL) + 1
    made = Heights(np.full(shape, np.inf), np.full(shape, -np.inf), corner)
    for corners, bottom, top in slabs:
        _raise(made, corners, grown, _level(bottom, top))
    for barrel, box in zip(barrels, boxes, strict=True):
        _raise(made, box, grown, _round(barrel, parameters.radius, grown))
    return made


def _plate(plate: Plate, parameters: "HingeParameters") -> tuple[list[Slab], list[Barrel]]:
    """Slabs (corners, bottom, top) and barrels (start, end, axis height) of a panel."""
    half = parameters.face_thickness / 2
    low, high = plate.height - half, plate.height + half
    slabs: list[Slab] = [(list(plate.core), low, high)]
    barrels = []
    for tab in plate.tabs:
        slabs.append((tab_points(tab, 0.0), low, high))
        barrels.append(_barrel(tab.hinge, tab.index))
    return slabs, barrels


def _link(link: Link, parameters: "HingeParameters") -> tuple[list[Slab], list[Barrel]]:
    section, r = link_section(parameters), parameters.radius
    lower, upper = link.hinges
    out = link.outward
    slabs: list[Slab] = []
    barrels: list[Barrel] = []
    for index in range(1, len(lower.segments), 2):
        ends = [lower.point(s) for s in lower.segments[index]]
        slabs.append((
            _ccw([ends[0] - r * out, ends[1] - r * out, ends[1] + section.outer * out,
                  ends[0] + section.outer * out]),
            lower.height, upper.height,
        ))  # fmt: skip
        barrels += [_barrel(hinge, index) for hinge in link.hinges]
    last = len(lower.segments) - 1 - (len(lower.segments) - 1) % 2 - 1
    a, b = lower.point(lower.segments[1][0]), lower.point(lower.segments[max(last, 1)][1])
    spine = [a + section.inner * out, b + section.inner * out, b + section.outer * out,
             a + section.outer * out]  # fmt: skip
    slabs.append((_ccw(spine), lower.height, upper.height))
    return slabs, barrels


def _barrel(hinge: Hinge, index: int) -> Barrel:
    """Plan points at which a knuckle starts and ends, and its axis' height; cones are within."""
    start, end = hinge.segments[index]
    return hinge.point(start), hinge.point(end), hinge.height


def _along(start: complex, end: complex, across: float) -> list[complex]:
    side = 1j * polygons.unit(end - start) * across
    return [start - side, end - side, end + side, start + side]


def _ccw(points: Sequence[complex]) -> Sequence[complex]:
    return points if polygons.area(points) > 0 else points[::-1]


def _level(bottom: float, top: float) -> Ends:
    """Function of plan points that gives a slab's bottom and top."""
    return lambda x, z: (bottom, top)


def _round(barrel: Barrel, radius: float, grown: float) -> Ends:
    """Function of plan points that gives a barrel's bottom and top."""
    start, end, height = barrel
    normal = 1j * polygons.unit(end - start)

    def ends(x: NDArray, z: NDArray) -> tuple[NDArray, NDArray]:
        off = np.abs(_beyond(x, z, start, normal))
        rise = np.sqrt(np.maximum(radius**2 - np.maximum(off - grown, 0.0) ** 2, 0.0))
        return height - rise, height + rise

    return ends


def _beyond(x: NDArray, z: NDArray, point: complex, normal: complex) -> NDArray:
    """How far (rows, columns) places x (columns,), z (rows, 1) lie beyond a line, mm."""
    return (x - point.real) * normal.real + (z - point.imag) * normal.imag


def _raise(made: Heights, corners: Sequence[complex], grown: float, ends: Ends) -> None:
    """Add a prism over a convex polygon (counter-clockwise), grown, to the rasters."""
    xs, zs = [p.real for p in corners], [p.imag for p in corners]
    reach = sqrt(2) * grown + PIXEL
    span = [
        slice(max(int((min(v) - reach - low) / PIXEL), 0), int((max(v) + reach - low) / PIXEL) + 1)
        for v, low in ((zs, made.corner.imag), (xs, made.corner.real))
    ]
    low, high = made.low[span[0], span[1]], made.high[span[0], span[1]]
    rows, columns = low.shape
    x = made.corner.real + (span[1].start + np.arange(columns) + 0.5) * PIXEL
    z = made.corner.imag + (span[0].start + np.arange(rows)[:, None] + 0.5) * PIXEL
    start, end = _stretches(corners, grown, z[:, 0])
    inside = (x >= start[:, None]) & (x <= end[:, None])
    bottom, top = ends(x, z)
    np.copyto(low, np.minimum(low, bottom), where=inside)
    np.copyto(high, np.maximum(high, top), where=inside)


def _stretches(corners: Sequence[complex], grown: float, z: NDArray) -> tuple[NDArray, NDArray]:
    """From where to where in x, at each of z (rows,), a grown convex polygon reaches."""
    start, end = np.full(len(z), -np.inf), np.full(len(z), np.inf)
    for a, b in zip(corners, [*corners[1:], corners[0]], strict=True):
        if a == b:
            continue
        normal = 1j * polygons.unit(b - a)
        rest = -grown - (z - a.imag) * normal.imag
        if abs(normal.real) < _UPRIGHT:
            end[rest > 0] = -np.inf
        elif normal.real > 0:
            np.maximum(start, a.real + rest / normal.real, out=start)
        else:
            np.minimum(end, a.real + rest / normal.real, out=end)
    return start, end


def mark_taken(hit: NDArray, spots: NDArray, bodies: Sequence[Heights], moves: NDArray) -> None:
    """Mark the ``spots`` (n, 3) that one of the ``bodies`` (`Heights`) takes at any pose.

    ``hit``: (n,) bool, written into; ``moves`` (bodies, m, 4, 4): of the spots as each sees them.
    """
    starts = np.arange(0, len(spots), _TOGETHER)
    least, most = (f.reduceat(spots, starts) for f in (np.minimum, np.maximum))
    for heights, ways in zip(bodies, moves, strict=True):
        ways = ways[_near(heights, ways, least.min(0)[None], most.max(0)[None])[:, 0]]
        pairs = np.argwhere(_near(heights, ways, least, most))
        for some in np.array_split(pairs, len(pairs) * _TOGETHER // _AT_ONCE + 1):
            _mark(hit, spots, heights, ways[some[:, 0]], starts[some[:, 1]])


def _near(heights: Heights, moves: NDArray, least: NDArray, most: NDArray) -> NDArray:
    """Whether boxes ``least`` … ``most`` (n, 3) meet a body's at motions (m, 4, 4): (m, n)."""
    turns = np.swapaxes(moves[:, :3, :3], -1, -2)
    centre = ((least + most) / 2) @ turns + moves[:, None, :3, 3]
    reach = ((most - least) / 2) @ np.abs(turns)
    low, high = heights.box
    return ((centre + reach > low) & (centre - reach < high)).all(-1)


def _mark(hit: NDArray, spots: NDArray, heights: Heights, moves: NDArray, starts: NDArray) -> None:
    """The same for one body, of groups of spots by where they start, each with a motion."""
    which = starts[:, None] + np.arange(_TOGETHER)
    np.minimum(which, len(spots) - 1, out=which)
    turned = spots[which] @ np.swapaxes(moves[:, :3, :3], -1, -2) + moves[:, None, :3, 3]
    low, high = heights.box
    inside = ((turned > low) & (turned < high)).all(-1) & ~hit[which]
    x, y, z = turned[inside].T
    bottom, above = heights.at(x, z)
    hit[which[inside][(y > bottom - _SURE) & (y < above + _SURE)]] = True
