# SPDX-License-Identifier: LGPL-2.1-or-later
"""Legs of the strip: parallel, or all through one point V; and a curve as it is seen along them."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import Refusal
from . import bezier
from .marching import Blocks

if TYPE_CHECKING:
    from .curve import Curve


class Legs:
    """Direction of the strip's legs at points in space: parallel, or all through one point V."""

    def __init__(self, legs: tuple[str, ArrayLike] | None = None) -> None:
        kind, vector = ("parallel", (0, 0, 1)) if legs is None else legs
        self.vector = np.asarray(vector, float)
        if kind not in ("parallel", "point") or self.vector.shape != (3,):
            raise Refusal(
                "{Ruling}: give ('parallel', direction) or ('point', V) with 3 numbers.",
                parameter="Ruling",
            )
        if not np.isfinite(self.vector).all() or (kind == "parallel" and not self.vector.any()):
            raise Refusal(
                "{Ruling}: the direction or viewpoint must be finite and not zero.",
                parameter="Ruling",
            )
        self.central = kind == "point"

    def at(self, points: NDArray) -> NDArray:
        """Unit vectors along the legs, pointing to "upper" (away from V): shape of ``points``."""
        if self.central:
            return bezier.normalised(points - self.vector)
        return np.broadcast_to(bezier.normalised(self.vector), np.shape(points))


class SeenAlong:
    """A curve as it is seen along parallel legs: projected onto the plane across them."""

    def __init__(self, curve: "Curve", legs: Legs) -> None:
        if legs.central:
            raise Refusal(
                "{Level}: legs through a viewpoint have no level; switch {Level} off.",
                parameter="Level",
            )
        self.curve, self.axis = curve, legs.at(np.zeros(3))
        for name in ("bend", "breaks"):
            if hasattr(curve, name):
                setattr(self, name, getattr(curve, name))

    def point(self, s: NDArray) -> NDArray:
        points = self.curve.point(s)
        return points - (points @ self.axis)[..., None] * self.axis

    def lifted(self, blocks: Blocks, closed: bool = False) -> "Blocks":
        """Blocks moved along the legs up to the curve.

        Every joint gets the mean height of the curve at its two midpoints. (Midpoints exactly on
        the curve would make each joint's height depend on all before it, and tilt more and more.)
        ``closed``: the last block is the first.
        """
        seen = np.array(blocks.midpoints)
        heights = np.asarray(self.curve.point(np.array(blocks.parameters)), float) @ self.axis
        points = seen + (heights - seen @ self.axis)[:, None] * self.axis
        joints = (heights[:-1] + heights[1:]) / 2
        first, last = 2 * heights[:1] - joints[:1], 2 * heights[-1:] - joints[-1:]
        if closed:
            first, last = joints[-1:], joints[:1]
        ends = np.concatenate([first, joints, last])
        off = (ends[:-1] + ends[1:]) / 2 - heights
        reaches = np.array(blocks.reaches) + (np.diff(ends) / 2)[:, None] * self.axis
        midpoints = points + off[:, None] * self.axis
        return Blocks(blocks.parameters, list(midpoints), list(reaches), blocks.sines)
