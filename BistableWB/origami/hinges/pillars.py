# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pillars: loose posts that hold up, in a flat print, what no stand-off can.

In a stack of units links, borders and blocks reach beyond the unit below them. A pillar stands on
the bed, or a layer of air above what lies below, and ends a layer of air under what it holds: it
touches nothing and falls out when the tube is opened for the first time.
"""

from collections.abc import Iterable
from itertools import pairwise
from typing import NamedTuple

from .boundary import Boundary
from .drafting import Draft

BED = -1
_BASE_LAYERS = 2  # of the wider base on the bed
BASE = 1.0  # mm that it is wider to all sides


class Pillar(NamedTuple):
    """A square post about ``(x, y)`` from ``low`` to ``high``, ``width`` wide (mm).

    ``holds``: number of the body that it holds; ``on``: of the one it stands over, or `BED`;
    ``base``: mm that it is wider at its foot; ``layer``: mm of one.
    """

    x: float
    y: float
    low: float
    high: float
    width: float
    holds: int
    on: int
    base: float
    layer: float

    def draw(self, draft: Draft) -> None:
        """Its faces."""
        rings = [(self.low, self.width / 2), (self.high, self.width / 2)]
        if self.base:
            half, step = self.width / 2 + self.base, self.low + _BASE_LAYERS * self.layer
            rings = [(self.low, half), (step, half), (step, rings[0][1]), rings[1]]
        made = []
        for z, half in rings:
            corners = ((-half, -half), (half, -half), (half, half), (-half, half))
            made.append([draft.vertex((self.x + dx, self.y + dy, z)) for dx, dy in corners])
        for low, high in pairwise(made):
            for k in range(4):
                m = (k + 1) % 4
                draft.polygon(low[k], low[m], high[m], high[k])
        draft.polygon(*reversed(made[0]))
        draft.polygon(*made[-1])

    def boundary(self) -> Boundary:
        """Its `Boundary`."""
        return boundary_of([self])


def boundary_of(pillars: Iterable[Pillar]) -> Boundary:
    """One `Boundary` of all ``pillars``, where they stand."""
    draft = Draft()
    for pillar in pillars:
        pillar.draw(draft)
    return draft.boundary()
