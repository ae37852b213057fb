# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which body a point of a layer lies in: sections of meshes, looked up."""

import numpy as np

from ..checks.layers import PIXEL, crossings

NOBODY = -1


class Sections:
    """Meshes in layers, from the lowest one up: what lies below the last one asked for is gone.

    ``meshes``: closed `Mesh` list, on the bed at z = 0; a body is named by its place in the list.
    """

    def __init__(self, meshes, layer_height):
        self._meshes, self._height = meshes, layer_height
        heights = np.array([mesh.bounds[:, 2] for mesh in meshes]) / layer_height
        self._layers = np.rint(heights).astype(int)  # first, and the one above the last
        self._rows = {}

    def owner(self, layer, points):
        """Body (n,) that holds each of the points (n, 2) of a layer (0 on the bed), or `NOBODY`.

        Points are taken to the middle of their row (`PIXEL`).
        """
        found = np.full(len(points), NOBODY)
        first, end = self._layers.T
        here = np.flatnonzero((first <= layer) & (layer < end)).tolist()
        self._rows = {body: self._rows.get(body) or self._made(body) for body in here}
        for body, rows in self._rows.items():
            near = np.flatnonzero(rows.may_hold(points))
            found[near[rows.holds(layer, points[near])]] = body
        return found

    def _made(self, body):
        return _Rows(self._meshes[body], self._height)


class _Rows:
    """Where a body's outline crosses rows of its layers: left of its points it does so oddly."""

    def __init__(self, mesh, layer_height):
        self._low, self._high = mesh.bounds[:, :2]
        layer, row, x, _ = crossings(mesh, layer_height)
        self._keys = np.sort(self._key(layer, row, x))

    def _key(self, layer, row, x):
        """One number by which (layer, row, x) are in order."""
        size = self._high - self._low + 4 * PIXEL
        rows = np.ceil(size[1] / PIXEL)
        row = row - np.floor(self._low[1] / PIXEL)
        return (layer * rows + row) * size[0] + (x - self._low[0] + PIXEL)

    def may_hold(self, points):
        """Whether points lie in the outline's box: (n,) bool."""
        return ((points > self._low) & (points < self._high)).all(1)

    def holds(self, layer, points):
        """Whether points of the box lie inside: (n,) bool."""
        row = np.floor(points[:, 1] / PIXEL)
        start = self._key(layer, row, self._low[0] - PIXEL)
        left = np.searchsorted(self._keys, self._key(layer, row, points[:, 0]))
        return (left - np.searchsorted(self._keys, start)) % 2 == 1
