# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the two bodies of every hinge touch: the cones, or pins, of its knuckles (hinges.md 4).

A hinge is held where its cones are, and there along a cone. Let w be the displacement of the second
body of a crease (`creases.CREASES`) against the first at one such place, in the first body's flat
frame, a its part along the axis and r the rest. All contacts obey one law,

    slope |r| <= k gap + lean a,

k being 1 for the hinges as they are printed. A cone on the first body has slope tan(ConeAngle) and
lean 1: the recess, on the second, moves off along the axis. On the second body its lean is −1. As
cones of both bodies look the same way along the hinge, together they hold it axially, at ± gap.

A cone touches its recess with its own tip or at the recess's mouth: two circles. Where a knuckle
tilts, a circle's points move along the axis too; to first order that is as if it touched where
the surface's normals through the circle meet the axis, its radius / tan(ConeAngle) before it. So
these are the two places of a cone, and the law is exact to first order.

The knuckles of a double hinge's two bodies must not meet either (`barrels`).

A pin in a ring has slope 1 and lean 0 at the ends of the ring, and end faces (slope 0, lean ± 1).
Flexible strips have no play, and no contacts here.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import tan
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..errors import Refusal
from ..hinges.bodies import tube_layouts
from ..hinges.parameters import PIN
from ..thick.closure import FIRST, SECOND
from ..units.creases import CREASES
from .barrels import Barrels, barrels

if TYPE_CHECKING:
    from ..hinges.parameters import HingeParameters
    from ..hinges.unit_layout import Hinge, Layout
    from ..thick.linkage import ThickUnit

Floats = NDArray[np.float64]
YIELD = 0.01  # of the clearance: what barrels of double hinges seem to give way by


@dataclass(frozen=True)
class Contacts:
    """All contacts of n units: m places a hinge, of which those not ``valid`` are only padding.

    ``points`` (n, 23, m, 3): on the axis, in the unit's flat frame, mm; ``axes`` (n, 23, 3): unit
    vectors along the hinges, in which cones point; ``slope``, ``lean``, ``valid`` (n, 23, m): the
    law above; ``cones`` (n, 23, m): which cone (ring) of its hinge a place belongs to, from 0;
    ``gap``: ga, mm. Bodies are `closure.FIRST` and `closure.SECOND` of the hinge. ``barrels``:
    where double hinges' knuckles meet, if that counts.
    """

    points: Floats
    axes: Floats
    slope: Floats
    lean: Floats
    valid: NDArray[np.bool_]
    cones: NDArray[np.int_]
    gap: float
    barrels: Barrels | None = None

    def __len__(self) -> int:
        return len(self.points)

    def take(self, units: NDArray) -> "Contacts":
        """The contacts of some units of the batch (index, slice or mask)."""
        names = "points", "axes", "slope", "lean", "valid", "cones"
        taken = {name: getattr(self, name)[units] for name in names}
        return replace(self, **taken, barrels=self.barrels and self.barrels.take(units))

    def scaled(self, factor: float) -> "Contacts":
        """The same with lengths times ``factor``: 1 / ‖AB‖ for poses in edge lengths."""
        return replace(
            self, points=factor * self.points, gap=factor * self.gap,
            barrels=self.barrels and self.barrels.scaled(factor),
        )  # fmt: skip

    def carriers(self) -> NDArray[np.int_]:
        """Body (index into `creases.BODIES`) on which the cone of each place is: (n, 23, m)."""
        return np.where(self.lean > 0, FIRST[:, None], SECOND[:, None])

    def displacement(self, poses: Floats) -> tuple[Floats, Floats]:
        """(a, r): along the axis (n, 23, m) and across it (n, 23, m, 3), for poses (n, 15, 4, 4).

        Of the second body against the first, in the first one's flat frame.
        """
        first, second = poses[:, FIRST], poses[:, SECOND]
        moved = rigid.apply(second, self.points) - first[..., None, :3, 3]
        found = moved @ first[..., :3, :3] - self.points
        along = (found * self.axes[:, :, None]).sum(-1)
        return along, found - along[..., None] * self.axes[:, :, None]

    def arms(self, poses: Floats) -> Floats:
        """Derivative (n, 23, m, 3, 6) of the displacement w = r + a · axis by the relative twist.

        The relative twist is that of the second body less that of the first, each a small rotation
        (world axes, about the origin) and a displacement, as `closure.Closure.moved` takes them.
        """
        back = np.swapaxes(poses[:, FIRST, :3, :3], -1, -2)[:, :, None]
        there = rigid.apply(poses[:, SECOND], self.points)
        return np.concatenate([-back @ rigid.skew(there), np.broadcast_to(back, (*there.shape, 3))],
                              -1)  # fmt: skip

    def needed(self, poses: Floats) -> Floats:
        """Factor k on the clearance that each place needs at given poses: (n, 23, m).

        −inf for padding.
        """
        along, across = self.displacement(poses)
        needed = self.slope * np.linalg.norm(across, axis=-1) - self.lean * along
        return np.where(self.valid, needed / self.gap, -np.inf)

    def most_needed(self, poses: Floats) -> Floats:
        """Factor on the clearance that poses need (n,), at least 0; barrels count, and hardly give.

        What barrels lack counts as if they gave way by `YIELD` of the clearance.
        """
        most = np.maximum(self.needed(poses).max((1, 2)), 0)
        if self.barrels is None:
            return most
        lack = -self.barrels.room(poses)[0].min((1, 2))
        return np.maximum(most, lack / (YIELD * self.gap))

    def needed_slopes(self, poses: Floats) -> Floats:
        """Derivative (n, 23, m, 6) of `needed` by the relative twist of `arms`; 0 for padding."""
        _, across = self.displacement(poses)
        length = np.linalg.norm(across, axis=-1, keepdims=True)
        outward = across / np.where(length > 0, length, 1.0)
        pull = self.slope[..., None] * outward - self.lean[..., None] * self.axes[:, :, None]
        pull = np.where(self.valid[..., None], pull, 0.0) / self.gap
        return (pull[..., None, :] @ self.arms(poses))[..., 0, :]


def contacts(laid_out: "Sequence[Layout]", parameters: "HingeParameters") -> Contacts:
    """`Contacts` of the hinges of units, by their `unit_layout.Layout` (one each).

    ``parameters``: `HingeParameters`. Refuses flexible hinges.
    """
    if not parameters.has_knuckles:
        raise Refusal(
            "Flexible hinges have no cones or pins.", parameter="HingeType",
            cure="set {HingeType} to Rotational",
        )  # fmt: skip
    places = _rings if parameters.pivot == PIN else _cones
    found = [
        [places(layout.hinges[crease.name], parameters) for crease in CREASES]
        for layout in laid_out
    ]
    most = max(len(hinge) for unit in found for hinge in unit)
    table = np.zeros((len(laid_out), len(CREASES), most, 5))
    for u, unit in enumerate(found):
        for h, hinge in enumerate(unit):
            table[u, h, : len(hinge), :4] = hinge
            table[u, h, : len(hinge), 4] = 1
    origins, axes = lines(laid_out)
    points = origins[:, :, None] + table[..., :1] * axes[:, :, None]
    return Contacts(
        points, axes, table[..., 1], table[..., 2], table[..., 4] > 0, table[..., 3].astype(int),
        parameters.gap_length, barrels(laid_out, origins, axes, parameters),
    )  # fmt: skip


def holding(thick: "ThickUnit", parameters: "Any") -> Contacts | None:
    """`Contacts` of the hinges of a `linkage.ThickUnit`, one or a batch; None for flexible ones."""
    if not parameters.has_knuckles:
        return None
    return contacts(tube_layouts(thick, parameters), parameters)


def outermost(found: Contacts) -> Contacts:
    """Only the outermost places of each law (slope, lean) on every hinge: what rigid bodies feel.

    Along a hinge of rigid bodies displacements vary linearly, and the law is convex: places between
    two of the same kind never need more clearance than both.
    """
    n, hinges, most = found.valid.shape
    along = ((found.points - found.points[:, :, :1]) * found.axes[:, :, None]).sum(-1)
    keys = np.stack([found.slope, found.lean], -1).reshape(-1, 2)
    columns = []
    for key in np.unique(keys[found.valid.ravel()], axis=0):
        same = (keys == key).all(-1).reshape(n, hinges, most) & found.valid
        low = np.where(same, along, np.inf).argmin(-1)
        high = np.where(same, along, -np.inf).argmax(-1)
        there = same.any(-1)
        columns += [(low, there), (high, there & (high != low))]
    order = np.stack([column for column, _ in columns], -1)
    valid = np.stack([there for _, there in columns], -1)

    def pick(array: NDArray) -> NDArray:
        return np.take_along_axis(array, order, 2)

    points = np.take_along_axis(found.points, order[..., None], 2)
    return Contacts(
        points, found.axes, pick(found.slope), pick(found.lean), valid, pick(found.cones),
        found.gap, found.barrels,
    )  # fmt: skip


def lines(laid_out: "Sequence[Layout]") -> tuple[Floats, Floats]:
    """Origins and directions (n, 23, 3) of the axes, flat (plan x, z; stack y)."""
    hinges = [[layout.hinges[crease.name] for crease in CREASES] for layout in laid_out]
    origins = [[(h.origin.real, h.height, h.origin.imag) for h in unit] for unit in hinges]
    axes = [[(h.direction.real, 0.0, h.direction.imag) for h in unit] for unit in hinges]
    return np.array(origins), np.array(axes)


def _cones(hinge: "Hinge", parameters: "HingeParameters") -> list[tuple[float, float, float, int]]:
    """(along the axis, slope, lean, cone) of both places of every cone of a hinge."""
    slope = tan(parameters.cone_angle)
    found = []
    for k, (base, carrier) in enumerate(hinge.cones):
        mouth = parameters.gap_length, parameters.cone_base
        tip = hinge.cone_height, parameters.tip_radius(hinge.cone_height)
        for deep, radius in (mouth, tip):
            along = base + deep - radius / slope
            found.append((along, slope, 1.0 if carrier == 0 else -1.0, k))
    return found


def _rings(hinge: "Hinge", parameters: "HingeParameters") -> list[tuple[float, float, float, int]]:
    """The same for the rings that turn on a pin: both their ends, and their end faces."""
    del parameters
    found = []
    for k, (start, end) in enumerate(hinge.segments[1::2]):
        found += [(start, 1.0, 0.0, k), (end, 1.0, 0.0, k)]
        found += [(start, 0.0, 1.0, k), (end, 0.0, -1.0, k)]
    return found
