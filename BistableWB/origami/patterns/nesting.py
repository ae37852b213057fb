# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pieces nested on sheets: triangles in pairs, then boxes on a skyline, turned by 90° at will.

Shapes are lists of convex polygons, corners as complex numbers (mm), anticlockwise.
"""

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..errors import Refusal


class Placed(NamedTuple):
    """Piece number ``piece`` on sheet ``sheet`` (from 0), at ``turn`` · z + ``shift``."""

    piece: int
    sheet: int
    turn: complex
    shift: complex


class _Box(NamedTuple):
    """Pieces with their turns and shifts in a box with its lower left corner at 0."""

    pieces: tuple
    width: float
    height: float


# Orders in which boxes are tried: long ones first, large ones, high ones.
_ORDERS: tuple[Callable[[_Box], float], ...] = (
    lambda box: -max(box.width, box.height),
    lambda box: -box.width * box.height,
    lambda box: -min(box.width, box.height),
)


def nested(
    outlines: Sequence[NDArray], stock: tuple[float, float], spacing: float, margin: float
) -> list[Placed]:
    """`Placed` of every outline on sheets ``stock`` (width, height), ``spacing`` apart.

    ``margin``: kept free along the sheets' edges. `TooLarge` names a piece that fits no sheet.
    """
    room = stock[0] - 2 * margin, stock[1] - 2 * margin
    alone = [_lying(k, outline) for k, outline in enumerate(outlines)]
    for box in alone:
        if not _fits(box, room):
            raise TooLarge(box.pieces[0][0], box.width, box.height, room)
    paired = _paired(alone, outlines, spacing, room)
    tried = [
        _packed(sorted(boxes, key=rank), room, spacing, margin)
        for boxes in (paired, alone)
        for rank in _ORDERS
    ]
    return min(tried, key=lambda found: (max(p.sheet for p in found), _spread(found)))


def _spread(found: Sequence[Placed]) -> int:
    """Pieces on the last sheet: of two nestings the one with the emptier last sheet is better."""
    last = max(place.sheet for place in found)
    return sum(place.sheet == last for place in found)


def _packed(
    boxes: Sequence[_Box], room: tuple[float, float], spacing: float, margin: float
) -> list[Placed]:
    """Boxes in their order, each on the first sheet that holds it."""
    sheets: list[_Skyline] = []
    found: list[Placed] = []
    for box in boxes:
        for number in range(len(sheets) + 1):
            if number == len(sheets):
                sheets.append(_Skyline(room, spacing))
            place = sheets[number].put(box)
            if place is not None:
                turn, shift = place
                shift += complex(margin, margin)
                found += [
                    Placed(index, number, turn * own, turn * at + shift)
                    for index, own, at in box.pieces
                ]
                break
    return sorted(found, key=lambda place: place.piece)


class TooLarge(Exception):
    """Piece ``index`` that is ``width`` × ``height`` mm and does not fit ``room``."""

    def __init__(self, index: int, width: float, height: float, room: tuple[float, float]) -> None:
        super().__init__(f"piece {index} is too large")
        self.index, self.width, self.height, self.room = index, width, height, room


def _fits(box: _Box, room: tuple[float, float]) -> bool:
    sizes = sorted((box.width, box.height)), sorted(room)
    return all(a <= b + 1e-9 for a, b in zip(*sizes, strict=True))


def _lying(index: int, outline: NDArray) -> _Box:
    """A piece in its smallest box, one of its edges along it."""
    best: Any = None
    for along in np.roll(outline, -1) - outline:
        turn = complex(abs(along) / along)
        spun = outline * turn
        width, height = float(np.ptp(spun.real)), float(np.ptp(spun.imag))
        if best is None or width * height < best[0] * (1 - 1e-9):
            best = width * height, turn, spun, width, height
    _, turn, spun, width, height = best
    return _Box(((index, turn, -complex(spun.real.min(), spun.imag.min())),), width, height)


def _paired(
    boxes: list[_Box], outlines: Sequence[NDArray], spacing: float, room: tuple[float, float]
) -> list[_Box]:
    """Boxes with triangles that lie well in pairs put together, like to like."""
    triangles = [box for box in boxes if len(outlines[box.pieces[0][0]]) == 3]
    triangles.sort(key=lambda box: (round(box.width), round(box.height)))
    result = [box for box in boxes if len(outlines[box.pieces[0][0]]) != 3]
    while triangles:
        first = triangles.pop()
        if not triangles:
            result.append(first)
            break
        second = triangles[-1]
        pair = _pair(first, second, outlines, spacing)
        saved = first.width * first.height + second.width * second.height
        if _fits(pair, room) and pair.width * pair.height < 0.9 * saved:
            triangles.pop()
            result.append(pair)
        else:
            result.append(first)
    return result


def _pair(first: _Box, second: _Box, outlines: Sequence[NDArray], spacing: float) -> _Box:
    """Two triangles in one box: the second turned half round, as near as spacing lets it."""
    (i, turn, shift), (j, other, offset) = first.pieces[0], second.pieces[0]
    still = outlines[i] * turn + shift
    spun = -(outlines[j] * other + offset) + complex(second.width, second.height)
    best = None
    for lift in (0.0, first.height - second.height):
        for sense in (1, -1):
            moved = spun + 1j * lift
            low, high = 0.0, first.width + second.width + 2 * spacing
            for _ in range(40):
                middle = (low + high) / 2
                if distance(still, moved + sense * middle) >= spacing:
                    high = middle
                else:
                    low = middle
            laid = moved + sense * high
            both = np.concatenate([still, laid])
            size = float(np.ptp(both.real)), float(np.ptp(both.imag))
            if best is None or size[0] * size[1] < best[0]:
                corner = complex(both.real.min(), both.imag.min())
                best = size[0] * size[1], size, corner, sense * high + 1j * lift
    assert best is not None
    _, size, corner, step = best
    second_shift = -offset + complex(second.width, second.height) + step
    pieces = (i, turn, shift - corner), (j, -other, second_shift - corner)
    return _Box(pieces, *size)


def distance(one: NDArray, other: NDArray) -> float:
    """Distance (mm) of two convex polygons along the edge normal that parts them best.

    Below 0: they overlap. Never more than their true distance.
    """
    best = -np.inf
    for a, b in ((one, other), (other, one)):
        along = np.roll(a, -1) - a
        out = along / np.abs(along) * -1j
        heights = ((b[None, :] - a[:, None]) * out.conj()[:, None]).real.min(1)
        best = max(best, float(heights.max()))
    return best


class _Skyline:
    """One sheet that is filled from below: (x, width, height) of the steps of what lies on it."""

    def __init__(self, room: tuple[float, float], spacing: float) -> None:
        self.room, self.spacing = room, spacing
        self.steps = [(0.0, room[0], 0.0)]

    def put(self, box: _Box) -> tuple[complex, complex] | None:
        """Turn and shift with which a box lies lowest, and it lies there; None: no room."""
        best: Any = None
        for turned in (False, True):
            width, height = (box.height, box.width) if turned else (box.width, box.height)
            for k in range(len(self.steps)):
                x, y = self.steps[k][0], self._level(k, width)
                if y is None or y + height > self.room[1] + 1e-9:
                    continue
                rank = y + height, x
                if best is None or rank < best[0]:
                    best = rank, x, y, width, height, turned
        if best is None:
            return None
        _, x, y, width, height, turned = best
        self._raise(x, width + self.spacing, y + height + self.spacing)
        return (1j, complex(x + width, y)) if turned else (1, complex(x, y))

    def _level(self, k: int, width: float) -> float | None:
        """Height at which something ``width`` wide lies from step k on."""
        x = self.steps[k][0]
        if x + width > self.room[0] + 1e-9:
            return None
        return max(h for start, wide, h in self.steps[k:] if start < x + width - 1e-9)

    def _raise(self, x: float, width: float, height: float) -> None:
        end = min(x + width, self.room[0])
        made = []
        for start, wide, level in self.steps:
            stop = start + wide
            if start < x:
                made.append((start, min(stop, x) - start, level))
            if stop > end:
                made.append((max(start, end), stop - max(start, end), level))
        made.append((x, end - x, height))
        self.steps = sorted(step for step in made if step[1] > 1e-9)


def stock_size(stock: Any) -> tuple[float, float]:
    """(width, height) mm of "2500x1250" or a pair; refuses anything else."""
    try:
        pair = stock.lower().split("x") if isinstance(stock, str) else stock
        width, height = (float(v) for v in pair)
    except (TypeError, ValueError, AttributeError):
        width = height = np.nan
    if not (50 <= width <= 1e5 and 50 <= height <= 1e5):
        raise Refusal(
            "Stock {stock!r} is no sheet: give its width x height in mm, such as 2500x1250.",
            stock=stock,
        )
    return width, height
