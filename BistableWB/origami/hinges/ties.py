# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ties: thin struts that hold what begins in mid-air while it is printed, and are cut afterwards.

A tie runs up from what lies below, at 45° from the vertical at most. It is a *neck*, one nozzle
wide, from end to end; where it is long, a *pillar*: wider, with a neck at both ends.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ..snap.materials import Material
from .boundary import Boundary
from .drafting import Draft

BED = -1
KNUCKLE_ACROSS = 8.0  # N, that a knuckle of PLA in a panel of 1.2 mm bears (docs/strength.md)
_OF_PLA, _OF_PANEL = 50.0, 1.2
NECK_LAYERS = 4  # height of a pillar's necks
PILLAR_IN_NECKS = 3.0  # how much wider a pillar is


class Tie(NamedTuple):
    """One tie: from ``foot`` to ``head`` (x, y, z mm, of its end faces), ``width`` of its necks.

    ``pillar``: width of its middle (0: a neck only); ``holds`` and ``on``: numbers of the body
    that it holds and of the one that it stands on (`BED`); ``layer``: mm of one.
    """

    foot: tuple
    head: tuple
    width: float
    pillar: float
    holds: int
    on: int
    layer: float

    @property
    def knee(self) -> NDArray:
        """Point from which it rises straight to its head: two layers below that."""
        return np.array([self.head[0], self.head[1], self.head[2] - 2 * self.layer])

    @property
    def cuts(self) -> list:
        """Points (x, y, z) at which it is cut: at its head, and at its foot unless on the bed."""
        ends = [(self.head[0], self.head[1], self.head[2] - 1.5 * self.layer)]
        way = self.knee - self.foot
        if self.on != BED and way[2] > 1.5 * self.layer:
            ends.append(tuple((np.array(self.foot) + way * 1.5 * self.layer / way[2]).tolist()))
        return ends

    def rings(self) -> list:
        """[(x, y, z, width)] of its sections, from below."""
        foot, way = np.array(self.foot), self.knee - self.foot
        stops, widths = [0.0, 1.0], [self.width] * 2
        if self.pillar:
            neck = NECK_LAYERS * self.layer / way[2]
            stops = [0.0, neck, 2 * neck, 1 - 2 * neck, 1 - neck, 1.0]
            widths = [self.width] * 2 + [self.pillar] * 2 + [self.width] * 2
            if self.on == BED:
                stops, widths = [0.0, *stops[3:]], widths[2:]
        points = [foot + stop * way for stop in stops]
        found = [(*point.tolist(), width) for point, width in zip(points, widths, strict=True)]
        return [*found, (*self.head, self.width)]

    def boundary(self) -> Boundary:
        """Its `Boundary`."""
        draft, rings = Draft(), []
        for x, y, z, width in self.rings():
            half = width / 2
            corners = ((-half, -half), (half, -half), (half, half), (-half, half))
            rings.append([draft.vertex((x + dx, y + dy, z)) for dx, dy in corners])
        for low, high in pairwise(rings):
            for k in range(4):
                m = (k + 1) % 4
                draft.polygon(low[k], low[m], high[m], high[k])
        draft.polygon(*reversed(rings[0]))
        draft.polygon(*rings[-1])
        return draft.boundary()


def breaking_force(width: float, material: Material) -> float:
    """Force (N) at which a neck of a ``width`` (mm) parts from a body, across the layers."""
    return width**2 * material.strength * material.layer_share


def knuckle_bears(face_thickness: float, material: Material) -> float:
    """Force (N) across a panel that a knuckle of it bears: it grows with the thickness squared."""
    return KNUCKLE_ACROSS * material.strength / _OF_PLA * (face_thickness / _OF_PANEL) ** 2


def cut_points(ties: Sequence[Tie]) -> NDArray:
    """Points (n, 3) of all cuts of ``ties``."""
    return np.array([point for tie in ties for point in tie.cuts]).reshape(-1, 3)
