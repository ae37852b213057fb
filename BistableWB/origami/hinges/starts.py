# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a printer begins in mid-air: islands of a layer, and what juts out too far from below.

On layers (`origami.layers`) of the bodies as they stand on the bed. An *island* is a piece of a
body's section that has nothing of the body below it; a *ledge* is what lies further than `REACH`
from what the body has in the layer below.
"""

from math import floor
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..layers import PIXEL, Layers, grown
from ..meshes import component_labels

REACH = 1.5  # mm beyond what lies below that a printer lays in the air
SMALL = 0.1  # mm²: less is no start


class Start(NamedTuple):
    """What of ``body`` (its number) begins in mid-air in a ``layer`` (number on the grid).

    ``pixels`` (n, 2): rows and columns of the grid; ``is_island``: nothing of the body is below.
    """

    body: int
    layer: int
    pixels: NDArray
    is_island: bool

    @property
    def area(self) -> float:
        """mm²."""
        return len(self.pixels) * PIXEL**2


def starts_of(number: int, made: Layers, support: Layers | None = None) -> list[Start]:
    """`Start`s of one body from its `Layers`, from below; ``support``: `Layers` that carry too."""
    reach = floor(REACH / PIXEL + 0.5)
    found: list[Start] = []
    for k, section in enumerate(made.inside):
        layer = int(made.first[0]) + k
        if layer == 0:
            continue  # on the bed
        below = made.inside[k - 1] if k else np.zeros_like(section)
        if support is not None:
            low, end = made.first.copy(), made.end
            low[0], end[0] = layer - 1, layer
            below = below | support.window(low, end)[0]
        fresh = section & ~below
        if fresh.any():
            found += _of_layer(number, layer, made.first[1:], section, below, fresh, reach)
    return found


def _of_layer(
    number: int,
    layer: int,
    corner: NDArray,
    section: NDArray,
    below: NDArray,
    fresh: NDArray,
    reach: int,
) -> list[Start]:
    """`Start`s in one layer; ``fresh``: of its section what is not below."""
    rows, columns = np.nonzero(fresh)
    low = np.maximum([rows.min() - reach - 1, columns.min() - reach - 1], 0)
    here = slice(low[0], rows.max() + reach + 2), slice(low[1], columns.max() + reach + 2)
    section, below, fresh = section[here], below[here], fresh[here]
    labels, count = labelled(fresh)
    carried = grown(section & below, 1)
    is_held = np.zeros(count + 1, bool)
    is_held[labels[carried & fresh]] = True
    island = fresh & ~is_held[labels]
    ledge = fresh & is_held[labels] & ~grown(below, reach)
    found = []
    for area, is_island in ((island, True), (ledge, False)):
        if not area.any():
            continue
        parts, many = labelled(area)
        for part in range(1, many + 1):
            pixels = np.argwhere(parts == part)
            if is_island or len(pixels) * PIXEL**2 > SMALL:
                found.append(Start(number, layer, pixels + low + corner, is_island))
    return found


def labelled(area: NDArray, corners: bool = True) -> tuple[NDArray, int]:
    """Numbers (rows, columns) of the connected pieces of a bool raster from 1 on, and how many.

    Pixels hang together along sides and, if wanted, ``corners``; numbers go by the first pixel.
    Joined are whole runs of a row, not pixels.
    """
    labels = np.zeros(area.shape, int)
    edges = np.diff(np.pad(area, ((0, 0), (1, 1))).astype(np.int8), axis=1)
    row, start = np.nonzero(edges > 0)
    if not len(row):
        return labels, 0
    end = np.nonzero(edges < 0)[1]
    wide = area.shape[1] + 2  # so that runs of all rows are in one order
    sides: tuple[Any, Any] = ("left", "right") if corners else ("right", "left")
    first = np.searchsorted(row * wide + end, (row + 1) * wide + start, sides[0])
    last = np.searchsorted(row * wide + start, (row + 1) * wide + end, sides[1])
    count = np.maximum(last - first, 0)
    upper = np.repeat(np.arange(len(row)), count)
    lower = np.arange(len(upper)) - np.repeat(np.cumsum(count) - count - first, count)
    itself = np.repeat(np.arange(len(row))[:, None], 2, 1)  # its label comes first
    pairs = np.concatenate([itself, np.stack([upper, lower], 1)])
    found = component_labels(pairs, len(row))[: len(row)] + 1
    labels[area] = np.repeat(found, end - start)
    return labels, int(found.max())
