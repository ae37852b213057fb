# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers cut into a face of a body, so that prints can be told apart.

Digits are squares of a grid of 3 x 5, all of one digit joined side by side: pockets with upright
walls, whose bars and inner islands a nozzle can lay.
"""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from . import polygons

if TYPE_CHECKING:
    from .drafting import Draft

ROWS, COLUMNS = 5, 3
_DIGITS = (
    "111101101101111", "010010010010010", "111001111100111", "111001111001111", "101101111001001",
    "111100111001111", "111100111101111", "111001001001001", "111101111101111", "111101111001111",
)  # fmt: skip


def width_of(text: str, size: float) -> float:
    """Width (mm) of a number in squares of ``size`` mm."""
    return ((COLUMNS + 1) * len(text) - 1) * size


def engrave(draft: "Draft", text: str, size: float, place: Callable) -> list:
    """Draws the pockets of digits and returns their rims: holes for the face that they are in.

    ``place(u, v, depth)``: the point at depth 0 (in the face) or 1 (on the floor), u mm to the
    right and v mm up from the lower left corner, as seen from outside. Rims run clockwise from
    outside.
    """
    rims = []
    for k, digit in enumerate(text):
        left = k * (COLUMNS + 1)
        loops = [
            [((x + left) * size, y * size) for x, y in loop] for loop in _loops(_DIGITS[int(digit)])
        ]
        outer = max(loops, key=lambda loop: polygons.area([complex(*p) for p in loop]))
        rims += _pocket(draft, outer, [loop for loop in loops if loop is not outer], place)
    return rims


def _pocket(draft: "Draft", outer: Sequence, islands: Sequence, place: Callable) -> list:
    """Draws a pocket within ``outer``, anticlockwise, around ``islands``, clockwise; its rim.

    Corners are (u, v) as in `engrave`.
    """
    floors, tops = [], []
    for loop in (outer, *islands):
        low, high = ([draft.vertex(place(u, v, depth)) for u, v in loop] for depth in (1, 0))
        for a, b, c, d in zip(low, high, [*high[1:], high[0]], [*low[1:], low[0]], strict=True):
            draft.polygon(a, b, c, d)
        floors.append(draft.ring(low))
        tops.append([~edge for edge in reversed(draft.ring(high))])
    draft.plane(*floors)
    for island in tops[1:]:
        draft.plane(island)
    return tops[:1]


def _loops(digit: str) -> list[list[tuple[int, int]]]:
    """Outlines of the squares of a digit, squares to the left: corners (x, y) of the grid."""
    filled = {
        (k % COLUMNS, ROWS - 1 - k // COLUMNS) for k, square in enumerate(digit) if square == "1"
    }
    after = {}
    for x, y in filled:
        for (dx, dy), start in (
            ((0, -1), (x, y)), ((1, 0), (x + 1, y)), ((0, 1), (x + 1, y + 1)), ((-1, 0), (x, y + 1))
        ):  # fmt: skip
            if (x + dx, y + dy) not in filled:
                after[start] = (start[0] - dy, start[1] + dx)
    loops = []
    while after:
        loop, here = [], min(after)
        while here in after:
            loop.append(here)
            here = after.pop(here)
        loops.append(_corners(loop))
    return loops


def _corners(loop: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """A loop without the points at which it goes straight on."""
    return [
        b
        for a, b, c in zip([loop[-1], *loop[:-1]], loop, [*loop[1:], loop[0]], strict=True)
        if (b[0] - a[0], b[1] - a[1]) != (c[0] - b[0], c[1] - b[1])
    ]
