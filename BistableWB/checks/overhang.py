# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of a layer hangs over air: neither carried from below nor spanned from hold to hold."""

from math import ceil, radians, sqrt, tan
from typing import NamedTuple

import numpy as np

from .layers import PIXEL


class Hang(NamedTuple):
    """What of one ``layer`` (number on the grid) hangs: ``area`` mm², the ``pixel`` of one place.

    ``wide``: a square of the printer's ``bridge`` fits into it.
    """

    layer: int
    area: float
    pixel: tuple
    wide: bool


def hangs(body, printer, support=None):
    """`Hang` of every layer of ``body`` (`Layers`) that needs a support which is not there.

    A pixel is carried by the body's own layer below, by the bed or by ``support`` (`Layers`) up to
    the overhang of ``printer.steepest``, rounded up to whole pixels. What lies between two carried
    pixels of its row or its column, at most ``printer.bridge`` apart, is a bridge.
    """
    reach = ceil(tan(radians(printer.steepest)) * printer.layer_height / PIXEL)
    span = round(printer.bridge / PIXEL)
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
        hanging, corner = _hanging(layer, below, reach, span)
        count = int(hanging.sum())
        if count:
            middle = _a_middle(hanging)
            pixel = k, middle[0] + corner[0], middle[1] + corner[1]
            wide = count >= span**2 and _holds_square(hanging, span)
            found.append(Hang(number, count * PIXEL**2, pixel, wide))
    return found


def _hanging(layer, below, reach, span):
    """Pixels of the part of ``layer`` that goes beyond ``below``, and where that part starts."""
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
    hanging = layer & ~carried
    if hanging.any() and carried.any():
        hanging &= ~(_bridges(hanging, carried, span) | _bridges(hanging.T, carried.T, span).T)
    return hanging, corner


def grown(area, radius):
    """All pixels within ``radius`` pixels of those of ``area`` (rows, columns) bool."""
    found = np.zeros_like(area)
    if not area.any():
        return found
    row, width = area.copy(), 0
    for dy in range(int(radius), -1, -1):
        for shift in range(width + 1, int(sqrt(radius**2 - dy**2)) + 1):
            row[:, shift:] |= area[:, :-shift]
            row[:, :-shift] |= area[:, shift:]
            width = shift
        found[dy:] |= row[: len(row) - dy]
        found[: len(row) - dy] |= row[dy:]
    return found


def _bridges(hanging, carried, span):
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


def _holds_square(area, side):
    """Whether a square of ``side`` pixels fits into an area."""
    if min(area.shape) < side:
        return False
    total = np.zeros((area.shape[0] + 1, area.shape[1] + 1), np.int32)
    np.cumsum(area, axis=0, dtype=np.int32, out=total[1:, 1:])
    np.cumsum(total, axis=1, out=total)
    inner = total[side:, side:] - total[:-side, side:] - total[side:, :-side]
    return bool((inner + total[:-side, :-side] == side**2).any())


def _a_middle(area):
    """The pixel in the middle of the longest row of an area, which lies in the area."""
    row = int(area.sum(1).argmax())
    columns = np.flatnonzero(area[row])
    return row, int(columns[len(columns) // 2])


def starts_in_air(body, others, printer, support=None):
    """Whether the lowest layer of ``body`` lies more than a bridge's length above anything else.

    Above the bed, and above all ``others`` (`Layers`) below it.
    """
    depth = ceil(printer.bridge / printer.layer_height)
    if body.first[0] <= depth:
        return False
    low, high = body.first.copy(), body.end
    low[0], high[0] = low[0] - depth, low[0]
    lowest = body.inside[0]
    below = [*others, *([support] if support is not None else [])]
    return not any(
        (other.window(low, high).any(0) & lowest).any()
        for other in below
        if (other.first < high).all() and (other.end > low).all()
    )
