# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where stand-offs may run on a panel's upper face: strips of a grid, along edges, across tabs."""

from collections.abc import Sequence
from math import ceil
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import polygons
from .standoff_inputs import StandOffs
from .unit_layout import Plate, Tab

Line = tuple[complex, complex]  # from one plan point to another

_INSIDE = 0.1  # mm from a strip's side to the edge of its face …
_BESIDE_BARRELS = 0.25  # … and to the edge of the core, which barrels turn beside
_FAR = 1e4  # mm
_CLEAR = 0.3  # mm between strips, which slicers do not close
_FINE = 0.05  # mm between places along a strip beside a hole
SHORTEST = 0.6  # mm that a piece of a strip is long at least


class Strip(NamedTuple):
    """``start`` (x + i z), ``direction`` (unit) and ``length`` (mm) of a strip's middle line."""

    start: complex
    direction: complex
    length: float

    def piece(self, low: float, high: float, width: float) -> tuple[complex, ...]:
        """Corners, counter-clockwise, of the strip from ``low`` to ``high`` mm along it."""
        side = 1j * self.direction * width / 2
        a, b = self.middle(low, high)
        return a - side, b - side, b + side, a + side

    def middle(self, low: float, high: float) -> Line:
        """Plan points of the middle line ``low`` and ``high`` mm along it."""
        return self.start + low * self.direction, self.start + high * self.direction

    def clear_of(self, pieces: Sequence[Line], along: NDArray, width: float) -> NDArray:
        """Which places ``along`` (n,) the strip keep clear of ``pieces`` of others, [(a, b)]."""
        points = self.start + along * self.direction
        clear = np.ones(len(along), bool)
        if not len(pieces):
            return clear
        ends = np.array(pieces)
        a, way = ends[:, 0], ends[:, 1] - ends[:, 0]
        half = self.length / 2
        middle = self.start + half * self.direction
        far = abs(a + way / 2 - middle) - abs(way) / 2 - half
        for k in np.flatnonzero(far <= _CLEAR + 2 * width):
            length = abs(way[k])
            seen = (points - a[k]) * (np.conj(way[k]) / length)  # along the piece, and beside it
            lean = abs(polygons.dot(self.direction, way[k] / length))
            apart = _CLEAR + (1 + lean) * width / 2
            past = np.maximum(np.maximum(-seen.real, seen.real - length), 0.0)
            clear &= past**2 + seen.imag**2 > apart**2
        return clear


def rims(plate: Plate, given: StandOffs) -> list[Strip]:
    """`Strip`s along the edges of a `Plate`'s core."""
    return _rims(list(plate.core), _BESIDE_BARRELS + given.width / 2, given.width)


def grid(plate: Plate, given: StandOffs) -> list[Strip]:
    """`Strip`s of a grid on a `Plate`'s core, both ways, clear of each other and of its rim."""
    inset = _BESIDE_BARRELS + (given.width + _CLEAR if given.rim else 0.0)
    inner = _inset(list(plate.core), inset)
    return _grid(inner, given.spacing, given.width) if inner else []


def strips_below(plate: Plate, lines: Sequence[Line], given: StandOffs) -> list[Strip]:
    """`Strip`s on a `Plate`'s core below ``lines`` of what lies above it, [(start, end)] in plan.

    Lines of knuckles, edges of panels.
    """
    inner = _inset(list(plate.core), _INSIDE)
    found = []
    for start, end in lines:
        along = polygons.unit(end - start)
        cut = _crossed(inner, start, along, given.width) if inner else None
        if cut:
            low, high = max(cut[0], _INSIDE), min(cut[1], abs(end - start) - _INSIDE)
            if high > low:
                found.append(Strip(start + low * along, along, high - low))
    return found


def beside_holes(
    corners: Sequence[complex], holes: Sequence[NDArray], wall: float
) -> list[tuple[complex, ...]]:
    """Corners of what is left of a strip, given by its `Strip.piece`, ``wall`` mm from holes.

    ``holes``: closed polygons (n,) of plan points.
    """
    a, b = (corners[0] + corners[3]) / 2, (corners[1] + corners[2]) / 2
    width = abs(corners[3] - corners[0])
    strip = Strip(a, polygons.unit(b - a), abs(b - a))
    along = np.linspace(0, strip.length, max(int(strip.length / _FINE), 1) + 1)
    points = strip.start + along * strip.direction
    free = np.ones(len(along), bool)
    for hole in holes:
        free &= _distance(points, hole) > width / 2 + wall
    if free.all():
        return [tuple(corners)]
    steps = np.flatnonzero(np.diff(np.concatenate([[False], free, [False]]).astype(int)))
    pieces = [(along[low], along[end - 1]) for low, end in steps.reshape(-1, 2)]
    return [strip.piece(low, high, width) for low, high in pieces if high - low >= SHORTEST]


def _distance(points: NDArray, polygon: NDArray) -> NDArray:
    """Distances (n,) of ``points`` (n,) from a closed polygon (m,), 0 within it."""
    a, b = polygon, np.roll(polygon, -1)
    share = ((points[:, None] - a) * np.conj(b - a)).real / abs(b - a) ** 2
    apart = abs(points[:, None] - a - np.clip(share, 0, 1) * (b - a)).min(1)
    turns = np.angle((b - points[:, None]) / (a - points[:, None])).sum(1)
    return np.where(abs(turns) > np.pi, 0.0, apart)


def _inset(core: Sequence[complex], by: float) -> list[complex]:
    return polygons.intersection(core, core, inset=by)


def _rims(core: Sequence[complex], inset: float, width: float) -> list[Strip]:
    """Along the edges of a core, apart at its corners."""
    corners = _inset(core, inset)
    found = []
    count = len(corners)
    for i in range(count):
        before, a, b, after = (corners[(i + k) % count] for k in (-1, 0, 1, 2))
        along = polygons.unit(b - a)
        low = _shortened(before, a, b, width)
        high = _shortened(a, b, after, width)
        if abs(b - a) - low - high > width:
            found.append(Strip(a + low * along, along, abs(b - a) - low - high))
    return found


def _shortened(before: complex, corner: complex, after: complex, width: float) -> float:
    """How far from a corner two strips along its edges end, to keep apart."""
    one, other = polygons.unit(before - corner), polygons.unit(after - corner)
    sine = max(abs(polygons.cross(one, other)), 0.3)
    if polygons.dot(one, other) < 0:  # the strips' ends face each other
        sine = max(sine, 0.7)
    return (width + _CLEAR) / sine


def _grid(inner: Sequence[complex], spacing: float, width: float) -> list[Strip]:
    """Ribs both ways, evenly apart; those along z are broken where those along x run."""
    found = []
    rows = _lines([p.imag for p in inner], spacing)
    for z in rows:
        cut = _crossed(inner, 1j * z, 1.0, width)
        if cut:
            found.append(Strip(complex(cut[0], z), 1.0 + 0j, cut[1] - cut[0]))
    gap = width / 2 + _CLEAR
    for x in _lines([p.real for p in inner], spacing):
        cut = _crossed(inner, complex(x, 0), 1j, width)
        if not cut:
            continue
        stops = [z for z in rows if cut[0] - gap < z < cut[1] + gap]
        lows = [cut[0], *(z + gap for z in stops)]
        highs = [*(z - gap for z in stops), cut[1]]
        for low, high in zip(lows, highs, strict=True):
            if high - low > width:
                found.append(Strip(complex(x, low), 1j, high - low))
    return found


def _lines(values: Sequence[float], spacing: float) -> list[float]:
    """Places of ribs, evenly ``spacing`` or less apart between the ends of ``values``."""
    low, high = min(values), max(values)
    count = ceil((high - low) / spacing - 1e-9)
    return [low + (high - low) * k / count for k in range(1, count)]


def _crossed(
    polygon: Sequence[complex], point: complex, direction: complex, width: float
) -> tuple[float, float] | None:
    """(low, high) along ``direction`` in which a strip through a plan point is inside, or None."""
    low, high = -_FAR, _FAR
    for side in (-width / 2, width / 2):
        start = point + side * 1j * direction
        forward = polygons.entry(polygon, start - _FAR * direction, direction)
        back = polygons.entry(polygon, start + _FAR * direction, -direction)
        if forward is None or back is None:
            return None
        low, high = max(low, forward[0] - _FAR), min(high, _FAR - back[0])
    return (low, high) if high - low > width else None


def strips_on_tabs(plate: Plate, given: StandOffs) -> list[Strip]:
    """`Strip`s along the axis on every tab whose upper face reaches it."""
    width, found = given.width, []
    inset = _INSIDE + width / 2
    for tab in plate.ring:
        if not isinstance(tab, Tab) or tab.hinge.height > plate.height:
            continue
        start, end = (tab.corner(k, inset) for k in (0, 1))
        along = polygons.unit(end - start)
        length = abs(end - start) - 2 * _INSIDE
        if length > 0:
            found.append(Strip(start + _INSIDE * along, along, length))
        deep = min(tab.depths) + _BESIDE_BARRELS - _CLEAR - inset - width / 2 - _CLEAR
        if deep > 0:  # across it, from there to the rim
            middle = (start + end) / 2 + (width / 2 + _CLEAR) * tab.inward
            found.append(Strip(middle, tab.inward, deep))
    return found
