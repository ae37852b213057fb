# SPDX-License-Identifier: LGPL-2.1-or-later
"""Do bodies that should move stay separate on the toolpaths? Contact between them in mm².

Every line of plastic is painted with its width onto a grid of its layer. It belongs to the body
whose section, at half the height of the layer (where slicers cut), contains its middle. Counted is,
for every two bodies,

- *beside*: length of the border between their painted areas in a layer × the height of the layer:
  lines of both that lie nearer to each other than the mean of their widths, and lines that run from
  one body into the other;
- *above*: area in which a line of one body lies on a line of the other in the layer right below,
  without a layer of air or support between.

Lines are painted as if they were as wide at their rounded sides as in their middle, so contact is
rather overestimated. Support is not counted: it comes off. What melts together though the paths are
apart, sagging and blobs, is not in these numbers either.
"""

from typing import NamedTuple

import numpy as np

from ..origami import progress as progresses
from .occupancy import CELL, Layers, near
from .sections import NOBODY

# Neighbours on the grid and what a border between them counts for: Crofton's formula for four
# directions, which is right to 5 % for a border in any direction.
_NEIGHBOURS = ((0, 1, 1.0), (1, 0, 1.0), (1, 1, 0.5**0.5), (1, -1, 0.5**0.5))
_CROFTON = np.pi / 8


class Contact(NamedTuple):
    """Contact between two bodies, named by their places in the list of bodies.

    mm²: ``beside`` each other in layers, ``above`` each other; ``point``: in the middle of the
    layer that has most of it, mm.
    """

    bodies: tuple
    beside: float
    above: float
    point: tuple

    @property
    def area(self):
        """All of it, mm²."""
        return self.beside + self.above


def contacts(lines, meshes, layer_height, progress=progresses.NOBODY):
    """`Contact` of every two bodies that touch, the largest first.

    ``lines``: `gcode.Lines` in layers of one height (mm); ``meshes``: `Mesh` of every body, where
    it was sliced. ``progress`` steps at every layer. ValueError where
    lines lie in none of the bodies: they were made of something else.
    """
    layers = Layers(lines.of_model(), meshes, layer_height)
    tally = {}
    before, this, below = None, layers.make(0), None
    for k in range(len(layers)):
        progress.step("", k / len(layers))
        after = layers.make(k + 1)
        image = this.painted(near([layer for layer in (before, this, after) if layer]))
        here = _counted(image, below, layers.grid.columns, layer_height)
        for pair, (beside, above, cells) in here.items():
            point = (*layers.grid.middle(cells), (k + 0.5) * layer_height)
            tally.setdefault(pair, []).append((beside, above, point))
        before, this, below = this, after, image
    layers.check_strays()
    return sorted(map(_total, tally.items()), key=lambda contact: -contact.area)


def _total(entry):
    """`Contact` of a pair and its (beside, above, point) in layers."""
    pair, parts = entry
    most = max(parts, key=lambda part: part[0] + part[1])
    return Contact(pair, sum(part[0] for part in parts), sum(part[1] for part in parts), most[2])


def _counted(image, below, columns, layer_height):
    """Contact in an image, and with the one ``below`` it: {pair: (beside, above, cells)}."""
    cells = np.flatnonzero(image != NOBODY)
    own, found = image[cells], []
    for row, column, weight in _NEIGHBOURS:
        other = image[cells + row * columns + column]
        found.append((own, other, weight * _CROFTON * CELL * layer_height, 0.0))
    if below is not None:
        found.append((own, below[cells], 0.0, CELL**2))
    sums = {}
    for one, other, beside, above in found:
        for pair, rows in _pairs(one, other):
            total = sums.setdefault(pair, [0.0, 0.0, []])
            total[0] += beside * len(rows)
            total[1] += above * len(rows)
            total[2].append(cells[rows])
    return {pair: (*areas, np.concatenate(where)) for pair, (*areas, where) in sums.items()}


def _pairs(one, other):
    """(two bodies, rows at which they meet) of cells' bodies (n,) and those of others (n,)."""
    rows = np.flatnonzero((one != other) & (other != NOBODY))
    both = np.sort(np.stack([one[rows], other[rows]], 1), axis=1)
    pairs, which = np.unique(both, axis=0, return_inverse=True)
    return [(tuple(pair), rows[which.ravel() == k]) for k, pair in enumerate(pairs.tolist())]
