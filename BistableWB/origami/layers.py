# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a printer lays down of a mesh: its sections in the middle of each layer, as rasters.

A pixel belongs to a layer if its middle lies inside the mesh at half the layer's height, which is
how slicers cut. Every raster lies on one grid of the print frame, so that those of different bodies
can be laid on each other. An area is right to about half a pixel along its outline.
"""

from collections.abc import Sequence
from math import sqrt
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from .meshes import Mesh

PIXEL = 0.1  # mm


class Layers(NamedTuple):
    """``inside`` (layers, rows, columns) bool, and ``first``: where it starts on the common grid.

    Layer i lies between the heights i h and (i + 1) h, row j and column k about y = (j + ½) PIXEL
    and x = (k + ½) PIXEL.
    """

    inside: np.ndarray
    first: np.ndarray

    @property
    def end(self) -> NDArray:
        """Layer, row and column behind the last ones."""
        return self.first + self.inside.shape

    def window(self, low: NDArray | Sequence[Any], high: NDArray | Sequence[Any]) -> NDArray:
        """The part between two corners (layer, row, column) of the grid; empty outside the body."""
        found = np.zeros(np.maximum(np.subtract(high, low), 0), bool)
        start, end = np.maximum(low, self.first), np.minimum(high, self.end)
        if (start < end).all():
            here = tuple(map(slice, start - low, end - low))
            found[here] = self.inside[tuple(map(slice, start - self.first, end - self.first))]
        return found

    def middle(self, index: NDArray | Sequence[Any], layer_height: float) -> tuple:
        """Point (x, y, z), mm, of a pixel (layer, row, column) of ``inside``."""
        layer, row, column = np.add(index, self.first) + 0.5
        return float(column * PIXEL), float(row * PIXEL), float(layer * layer_height)


class Tops:
    """Heights of what lies further below: of every place the highest layer in which something is.

    Asked for a window like `Layers`, it tells where that layer lies in it.
    """

    def __init__(self, low: NDArray, end: NDArray) -> None:
        """``low``, ``end``: (row, column) of the grid that it covers."""
        self.first = np.append(0, low)
        self.highest = np.full(np.subtract(end, low), -1, np.int16)

    @property
    def end(self) -> NDArray:
        """Layer, row and column behind the last ones."""
        return np.append(int(self.highest.max(initial=-1)) + 1, self.first[1:] + self.highest.shape)

    def add(self, one: Layers) -> None:
        """Put `Layers` below."""
        if not one.inside.size:
            return
        top = len(one.inside) - 1 - one.inside[::-1].argmax(0) + one.first[0]
        low, end = one.first[1:] - self.first[1:], one.end[1:] - self.first[1:]
        here = self.highest[low[0] : end[0], low[1] : end[1]]
        np.maximum(here, np.where(one.inside.any(0), top, -1), out=here)

    def part(self, low: NDArray, end: NDArray) -> NDArray:
        """Highest layers in a window (rows, columns), −1 where nothing is, also beyond the grid."""
        found = np.full(np.subtract(end, low), -1, np.int16)
        start = np.maximum(low, self.first[1:])
        stop = np.minimum(end, self.first[1:] + self.highest.shape)
        if (start < stop).all():
            into = tuple(map(slice, start - low, stop - low))
            here = tuple(map(slice, start - self.first[1:], stop - self.first[1:]))
            found[into] = self.highest[here]
        return found

    def window(self, low: NDArray, high: NDArray) -> NDArray:
        """(1, rows, columns) bool: where the highest layer lies between two corners of the grid."""
        top = self.part(low[1:], high[1:])
        return ((top >= max(low[0], 0)) & (top < high[0]))[None]


def extent(bounds: NDArray) -> tuple[NDArray, NDArray]:
    """(low, end), each (row, column), of the part of the grid that boxes (n, 2, 3), mm, lie in."""
    low = np.floor(bounds[:, 0, 1::-1].min(0) / PIXEL).astype(int) - 1
    return low, np.ceil(bounds[:, 1, 1::-1].max(0) / PIXEL).astype(int) + 2


def layers(mesh: "Mesh", layer_height: float) -> "Layers":
    """`Layers` of a closed `Mesh` in the print frame, from its first to its last; maybe none."""
    low, high = mesh.bounds / [PIXEL, PIXEL, layer_height]
    first = np.append(np.floor(low[2:] + 0.5), np.ceil(low[1::-1] - 0.5)).astype(int)
    end = np.append(np.floor(high[2:] + 0.5), np.ceil(high[1::-1] - 0.5) + 1).astype(int)
    shape = np.maximum(end - first, 0)
    if not shape.all():
        return Layers(np.zeros((0, 0, 0), bool), first)
    layer, row, x, sign = crossings(mesh, layer_height)
    column = np.ceil(x / PIXEL - 0.5).astype(int)
    steps_in = np.zeros(shape, np.int8)
    place = np.stack([layer, row, column]) - first[:, None]
    np.add.at(steps_in, tuple(place), sign)
    np.cumsum(steps_in, axis=2, dtype=np.int8, out=steps_in)
    inside = steps_in > 0
    laid = np.flatnonzero(inside.any((1, 2)))
    if not len(laid):
        return Layers(inside[:0], first)
    first[0] += laid[0]
    return Layers(inside[laid[0] : laid[-1] + 1], first)


def grown(area: NDArray, radius: float) -> NDArray:
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


def crossings(mesh: "Mesh", layer_height: float) -> tuple:
    """Where rows along x cross the mesh in the middle of layers: layer, row, x, sign (m,).

    A mesh is entered where the sign is +1, and left where it is −1.
    """
    return _crossed(*_sections(mesh, layer_height))


def _sections(mesh: "Mesh", layer_height: float) -> tuple[NDArray, ...]:
    """Edges of all sections: layer (n,), starts and ends (n, 2), the body to the left.

    Which way an edge runs follows from the order of its triangle's corners, not from a normal: so
    outlines close, whatever is rounded.
    """
    corners = mesh.corners
    order = np.argsort(corners[:, :, 2], 1)
    corners = np.take_along_axis(corners, order[:, :, None], 1)
    levels = corners[:, :, 2] / layer_height - 0.5
    first = np.floor(levels[:, 0]).astype(int) + 1  # the planes above the lowest corner …
    last = np.floor(levels[:, 2]).astype(int)  # … up to the highest one
    which, layer = _ranges(first, last)
    low, middle, high = np.moveaxis(corners[which], 1, 0)
    z = (layer + 0.5) * layer_height
    above = (levels[which, 1] < layer)[:, None]
    starts = _at(low, high, z)
    ends = _at(np.where(above, middle, low), np.where(above, high, middle), z)
    turned = ((order[:, 1] - order[:, 0]) % 3 != 1)[which][:, None]
    return layer, np.where(turned, ends, starts), np.where(turned, starts, ends)


def _at(low: NDArray, high: NDArray, z: NDArray) -> NDArray:
    """Points (n, 2) of edges at heights z."""
    share = _between((z - low[:, 2]) / (high[:, 2] - low[:, 2]))
    return low[:, :2] + share[:, None] * (high - low)[:, :2]


def _between(share: NDArray) -> NDArray:
    """Shares of edges that are almost level: what is rounded must not lead beyond their ends."""
    return np.clip(share, 0.0, 1.0)


def _crossed(layer: NDArray, starts: NDArray, ends: NDArray) -> tuple[NDArray, ...]:
    """What `crossings` returns, of the edges of sections."""
    sign = np.where(starts[:, 1] > ends[:, 1], 1, -1).astype(np.int8)
    down = (sign > 0)[:, None]
    starts, ends = np.where(down, ends, starts), np.where(down, starts, ends)
    rows = [np.ceil(points[:, 1] / PIXEL - 0.5).astype(int) for points in (starts, ends)]
    which, row = _ranges(rows[0], rows[1] - 1)
    starts, ends = starts[which], ends[which]
    share = _between(((row + 0.5) * PIXEL - starts[:, 1]) / (ends[:, 1] - starts[:, 1]))
    x = starts[:, 0] + share * (ends[:, 0] - starts[:, 0])
    return layer[which], row, x, sign[which]


def _ranges(first: NDArray, last: NDArray) -> tuple[NDArray, NDArray]:
    """(index of the range, number) for all whole numbers of ranges first … last."""
    count = np.maximum(last - first + 1, 0)
    which = np.repeat(np.arange(len(count)), count)
    start = np.cumsum(count) - count
    return which, np.arange(len(which)) - start[which] + first[which]
