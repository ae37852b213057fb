# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a layer hangs over air: neither carried from below nor spanned from hold to hold."""

from collections.abc import Sequence
from math import ceil, radians, tan
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..origami.layers import PIXEL, grown
from .starts import held_by

if TYPE_CHECKING:
    from .layers import Layers, Tops
    from .printer import Printer


_HALF_LINE = 2  # pixels: a line is held where half of it is


class Hang(NamedTuple):
    """What of one ``layer`` (number on the grid) hangs: ``area`` mm², the ``pixel`` of one place.

    ``wide``: a square of the printer's ``bridge`` fits into it.
    """

    layer: int
    area: float
    pixel: tuple
    wide: bool


def hangs(
    body: "Layers",
    printer: "Printer",
    support: "Layers | None" = None,
    others: "Sequence[Layers | Tops]" = (),
    depth: int = 0,
) -> list[Hang]:
    """`Hang` of every layer of ``body`` (`Layers`) that needs a support which is not there.

    A pixel is carried by the body's own layer below, by the bed or by ``support`` (`Layers`) up to
    the overhang of ``printer.steepest``, rounded up to whole pixels, and by ``others`` at most
    ``depth`` layers below. What lies between two carried pixels of its row or its column, at most
    ``printer.bridge`` apart, is a bridge; between stand-offs it is twice as long, so that nothing
    is further from a hold.
    """
    reach = ceil(tan(radians(printer.steepest)) * printer.layer_height / PIXEL)
    span = round(printer.bridge / PIXEL)
    bridge = 2 * span if depth else span
    found = []
    for k, layer in enumerate(body.inside):
        number = int(body.first[0]) + k
        if number == 0:
            continue  # on the bed
        below = body.inside[k - 1] if k else np.zeros_like(layer)
        if support is not None:
            low, high = body.first.copy(), body.end
            low[0] = number - 1
            high[0] = number
            below = below | support.window(low, high)[0]
        held = layer & held_by(others, body, number, depth) if depth else None
        hanging, corner = _hanging(layer, below, reach, bridge, held)
        count = int(hanging.sum())
        if count:
            middle = _a_middle(hanging)
            pixel = k, middle[0] + corner[0], middle[1] + corner[1]
            wide = count >= span**2 and _holds_square(hanging, span)
            found.append(Hang(number, count * PIXEL**2, pixel, wide))
    return found


def _hanging(
    layer: NDArray, below: NDArray, reach: float, span: int, held: NDArray | None = None
) -> tuple[NDArray, Any]:
    """Pixels of the part of ``layer`` that goes beyond ``below``, and where that part starts.

    ``held``: pixels that something else holds.
    """
    beyond = layer & ~below
    if not beyond.any():
        return beyond, (0, 0)
    window, corner = [], []
    for axis in (1, 0):
        places = np.flatnonzero(beyond.any(axis))
        low = max(int(places[0]) - span - 1, 0)
        corner.append(low)
        window.append(slice(low, int(places[-1]) + span + 2))
    layer, below = layer[tuple(window)], below[tuple(window)]
    carried = layer & grown(below, reach)
    if held is not None:
        carried |= layer & grown(held[tuple(window)], _HALF_LINE)
    hanging = layer & ~carried
    if hanging.any() and carried.any():
        hanging &= ~(_bridges(hanging, carried, span) | _bridges(hanging.T, carried.T, span).T)
    return hanging, corner


def _bridges(hanging: NDArray, carried: NDArray, span: int) -> NDArray:
    """Which hanging pixels lie in their row between two carried ones, at most ``span`` apart."""
    index = np.arange(hanging.shape[1])
    last = np.maximum.accumulate(np.where(hanging, -1, index), 1)
    following = np.where(hanging, len(index), index)[:, ::-1]
    following = np.minimum.accumulate(following, 1)[:, ::-1]
    short = hanging & (last >= 0) & (following < len(index)) & (following - last - 1 <= span)
    rows, columns = np.nonzero(short)
    held = carried[rows, last[rows, columns]] & carried[rows, following[rows, columns]]
    short[rows, columns] = held
    return short


def _holds_square(area: NDArray, side: int) -> bool:
    """Whether a square of ``side`` pixels fits into an area."""
    if min(area.shape) < side:
        return False
    total = np.zeros((area.shape[0] + 1, area.shape[1] + 1), np.int32)
    np.cumsum(area, axis=0, dtype=np.int32, out=total[1:, 1:])
    np.cumsum(total, axis=1, out=total)
    inner = total[side:, side:] - total[:-side, side:] - total[side:, :-side]
    return bool((inner + total[:-side, :-side] == side**2).any())


def _a_middle(area: NDArray) -> tuple[int, int]:
    """The pixel in the middle of the longest row of an area, which lies in the area."""
    row = int(area.sum(1).argmax())
    columns = np.flatnonzero(area[row])
    return row, int(columns[len(columns) // 2])
