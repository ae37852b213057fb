# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the barrels of double hinges meet: a limit to their play (hinges.md 4).

The two axes of a double hinge are two barrels' diameters and two gaps between planes apart, its
knuckles as thick as two panels and a gap: between both bodies' knuckles only the gap is left. Two
hinges whose play together is more would let them into each other; cones of 45° have so much.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..thick.closure import BODY
from ..units.creases import CREASES, LINKS

if TYPE_CHECKING:
    from ..hinges.parameters import HingeParameters
    from ..hinges.unit_layout import Hinge, Layout

Floats = NDArray[np.float64]


def _sides() -> tuple[NDArray, NDArray]:
    """Of every link its two hinges (indices into `creases.CREASES`) and the bodies they lead to.

    The right one comes first, as in all hinges of the right contact panel.
    """
    hinges, bodies = [], []
    for link in LINKS:
        own = [(k, crease) for k, crease in enumerate(CREASES) if link in crease.bodies]
        own.sort(key=lambda entry: -entry[1].height)
        hinges.append([k for k, _ in own])
        bodies.append([BODY[crease.bodies[0]] for _, crease in own])
    return np.array(hinges), np.array(bodies)


HINGES, _BODIES = _sides()
FIRST, SECOND = _BODIES.T


@dataclass(frozen=True)
class Barrels:
    """Knuckles of both bodies of the three double hinges of n units.

    ``first``, ``second`` (n, 3, 2, 3): the ends of what knuckles of body `FIRST` and of body
    `SECOND` take up, on their axes; ``axes`` (n, 3, 3): of the first; ``thickness``: diameter.
    Lengths in mm, all in the unit's flat frame.
    """

    first: Floats
    second: Floats
    axes: Floats
    thickness: float

    def take(self, units: Any) -> "Barrels":
        """Those of some units of the batch."""
        return replace(self, first=self.first[units], second=self.second[units],
                       axes=self.axes[units])  # fmt: skip

    def scaled(self, factor: float) -> "Barrels":
        """The same with lengths times ``factor``."""
        return replace(self, first=factor * self.first, second=factor * self.second,
                       thickness=factor * self.thickness)  # fmt: skip

    def room(self, poses: Floats) -> tuple[Floats, Floats]:
        """What is left between them (n, 3, 2) at poses (n, 15, 4, 4), and its derivatives.

        These (n, 3, 2, 6) are by the relative twist, the second body's less the first one's, as in
        `contact.Contacts.arms`.
        """
        one, other = poses[:, FIRST], poses[:, SECOND]
        there = rigid.apply(other, self.second)
        apart = there - rigid.apply(one, self.first)
        axes = (one[..., :3, :3] @ self.axes[..., None])[..., 0][:, :, None]
        apart = apart - (apart * axes).sum(-1, keepdims=True) * axes
        length = np.linalg.norm(apart, axis=-1)
        out = apart / length[..., None]
        return length - self.thickness, np.concatenate([np.cross(there, out), out], -1)


def barrels(
    laid_out: Sequence["Layout"], origins: Floats, axes: Floats, parameters: "HingeParameters"
) -> Barrels:
    """`Barrels` of units by their `unit_layout.Layout`, and their hinges' lines (n, 23, 3)."""
    reach = np.array([
        [[_reach(layout.hinges[CREASES[k].name]) for k in pair] for pair in HINGES]
        for layout in laid_out
    ])  # fmt: skip
    points = origins[:, HINGES][..., None, :] + reach[..., None] * axes[:, HINGES][..., None, :]
    return Barrels(points[:, :, 0], points[:, :, 1], axes[:, HINGES[:, 0]],
                   2 * parameters.radius)  # fmt: skip


def _reach(hinge: "Hinge") -> tuple[float, float]:
    """From where to where knuckles of a hinge's first body, every second one, reach."""
    return hinge.segments[0][0], hinge.segments[::2][-1][1]
