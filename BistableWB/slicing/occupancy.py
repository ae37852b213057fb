# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines of plastic, cut into pieces that belong to bodies and painted onto a grid, by layers."""

import numpy as np

from ..origami.errors import Refusal
from .sections import NOBODY, Sections

CELL = 0.05  # mm: of the grid on which lines are painted
STRAY_SHARE = 0.01  # of the lines' length that may lie in no body
_PIECE = 0.4  # mm: lines are cut into pieces so long; each belongs to one body
_POINTS = 0.7 * CELL  # distance of the points that paint a line: so near that no cell is left out
_ZONE = 20  # cells: of the coarse grid that tells where two bodies are near (a line is less wide)
# Where the middle of a piece lies in no body (a thin wall, a gap that the slicer closed), the
# nearest body within this many steps of a cell takes it.
_REACH = 6
_FAR = np.iinfo(np.int16).max


class Layers:
    """Lines of a print in layers of one height, with the bodies that they belong to.

    Made one after the other, from the lowest one up.
    """

    def __init__(self, lines, meshes, layer_height):
        self._lines, self._sections = lines, Sections(meshes, layer_height)
        self._layer = np.rint(lines.top / layer_height).astype(int) - 1
        self._count = int(self._layer.max(initial=-1)) + 1
        self.grid = Grid(lines.ends)
        self._all = self._stray = 0.0

    def __len__(self):
        return self._count

    def make(self, k):
        """`Layer` k; without lines beyond the last one."""
        lines = self._lines.chosen(self._layer == k)
        count = np.ceil(lines.lengths / _PIECE).astype(int)
        line = np.repeat(np.arange(len(count)), count)
        at = np.arange(len(line)) - np.repeat(np.cumsum(count) - count, count) + 0.5
        step = (lines.ends[:, 1] - lines.ends[:, 0])[line] / count[line, None]
        middle = lines.ends[line, 0] + at[:, None] * step
        owner = self._owner(k, middle)
        lengths = np.linalg.norm(step, axis=1)
        self._all += lengths.sum()
        self._stray += lengths[owner == NOBODY].sum()
        own = owner != NOBODY
        return Layer(self.grid, owner[own], middle[own], step[own], lines.width[line][own])

    def check_strays(self):
        """ValueError where too much was laid outside all bodies, of the layers made so far."""
        if self._stray > STRAY_SHARE * self._all:
            raise Refusal(
                "{stray:.0%} of the sliced lines lie in none of the bodies: slice the print that "
                "the bodies are of, without moving it on the bed.",
                stray=self._stray / self._all,
            )

    def _owner(self, k, points):
        """Body (n,) of every point, of the nearest one where it lies in none; else `NOBODY`."""
        owner = self._sections.owner(k, points)
        turns = np.arange(8) * np.pi / 4
        rays = np.stack([np.cos(turns), np.sin(turns)], 1) * CELL
        for reach in range(1, _REACH + 1):
            for ray in rays:
                lost = np.flatnonzero(owner == NOBODY)
                if len(lost):
                    owner[lost] = self._sections.owner(k, points[lost] + reach * ray)
        return owner


class Layer:
    """Pieces of lines in one layer: ``owner`` (n,), ``middle``, ``step`` (n, 2), ``width`` (n,).

    ``lowest`` and ``highest`` body in every coarse zone of the ``grid``.
    """

    def __init__(self, grid, owner, middle, step, width):
        self.grid = grid
        self._owner, self._middle, self._step, self._width = owner, middle, step, width
        self._zone = grid.zones(grid.cells(middle))
        shape = grid.rows // _ZONE, grid.columns // _ZONE
        self.lowest, self.highest = np.full(shape, _FAR, np.int16), np.full(shape, -1, np.int16)
        order = np.argsort(owner, kind="stable")  # the last of several values that are set stays
        row, column = self._zone
        self.highest[row[order], column[order]] = owner[order]
        order = order[::-1]
        self.lowest[row[order], column[order]] = owner[order]

    def painted(self, near):
        """Image of the pieces in the zones ``near``: the body, or `NOBODY`, of every cell."""
        image = np.full(self.grid.rows * self.grid.columns, NOBODY, np.int16)
        rows = np.flatnonzero(near[self._zone])
        if not len(rows):
            return image
        step, width = self._step[rows], self._width[rows]
        across = np.stack([-step[:, 1], step[:, 0]], 1)
        across /= np.linalg.norm(across, axis=1, keepdims=True)
        half = np.maximum(width - CELL, 0) / 2  # cells stick out from under the outermost points
        u = np.linspace(-0.5, 0.5, int(np.ceil(_PIECE / _POINTS)) + 1)
        v = np.linspace(-1, 1, int(np.ceil(width.max() / _POINTS)) + 1)
        points = self._middle[rows, None, None] + u[:, None, None] * step[:, None, None]
        points = points + v[:, None] * (half[:, None] * across)[:, None, None]
        image[self.grid.cells(points)] = self._owner[rows, None, None]
        return image


class Grid:
    """The plan around ``ends`` (…, 2) of lines in cells, with a border where nothing is painted."""

    def __init__(self, ends):
        border = 2 * _ZONE
        points = ends.reshape(-1, 2)
        self.low = points.min(0) - border * CELL
        size = np.ceil((points.max(0) - self.low) / CELL).astype(int) + border
        self.columns, self.rows = ((size // _ZONE + 1) * _ZONE).tolist()

    def cells(self, points):
        """Number of the cell of every point (…, 2): row × columns + column."""
        column, row = np.moveaxis(((points - self.low) / CELL).astype(np.int64), -1, 0)
        return row * self.columns + column

    def zones(self, cells):
        """Coarse (row, column) of cells."""
        row, column = np.divmod(cells, self.columns)
        return row // _ZONE, column // _ZONE

    def middle(self, cells):
        """Middle of the cells, (x, y) mm."""
        row, column = np.divmod(cells, self.columns)
        return tuple((self.low + CELL * (np.median([column, row], 1) + 0.5)).tolist())


def near(layers):
    """Zones (rows, columns) that have, with their neighbours in ``layers``, two bodies: bool."""
    low = np.minimum.reduce([layer.lowest for layer in layers])
    high = np.maximum.reduce([layer.highest for layer in layers])
    for axis in (0, 1):
        low, high = _spread(np.minimum, low, axis), _spread(np.maximum, high, axis)
    return low < high


def _spread(choose, values, axis):
    """Every value chosen from itself and its neighbours along an axis (the border is empty)."""
    return choose(choose(values, np.roll(values, 1, axis)), np.roll(values, -1, axis))
