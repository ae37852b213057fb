# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far a deployed tube moves before anything bears: the play of its hinges (theory/hinges.md 4).

Deployed and compensated, a unit closes exactly; within the clearance of its cones the contact
panels still move. A pull so soft that nothing bends leads each unit to the end of its freedom, in
every direction that is asked for; along a tube the units' motions add up, each with its own lever.
Lengths mm, angles radians.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..progress import NOBODY
from ..thick import print_stack
from ..thick.closure import RIGHT
from ..thick.thick_tube import block_lines
from ..units.creases import BODIES, INDEX
from .contact import contacts, outermost
from .elastic import bare_unit
from .minimum import Pull, least, start

if TYPE_CHECKING:
    from ..hinges.parameters import HingeParameters
    from ..hinges.unit_layout import Layout
    from ..progress import Progress
    from ..thick.linkage import ThickUnit

SOFT = 100.0  # N·mm: moves what is free; cones give way by some microns
_STAGES = (3e-2, 3e-3, 6e-4)  # what is left of the barrier takes half a percent of the freedom
AXES = "bend", "sway", "twist"


@dataclass(frozen=True)
class Slop:
    """Free motion of n deployed units, and of the tube's free end.

    ``angles`` (n, 3, 2): how far the right contact panel turns against the left one about the leg
    at B (bend), about the line square to leg and tube (sway) and about the tube (twist), negative
    and positive way, radians; ``ends`` (n, 3, 2): what each unit moves the tube's free end by along
    the tube's first two directions (`directions`, rows), mm, negative and positive way; ``poses``
    (n, 2, 2, 15, 4, 4): of each unit's bodies there, its left contact panel at rest, mm.
    """

    angles: NDArray
    ends: NDArray
    directions: NDArray
    poses: NDArray

    @property
    def bend(self) -> NDArray:
        """Half of the whole free turn about the leg at B (n,), radians."""
        return (self.angles[:, 0, 1] - self.angles[:, 0, 0]) / 2

    @property
    def twist(self) -> NDArray:
        """Half of the whole free turn about the tube (n,), radians."""
        return (self.angles[:, 2, 1] - self.angles[:, 2, 0]) / 2

    @property
    def end(self) -> float:
        """Farthest that the free end gets from its place, mm: all units the same way."""
        return float(np.abs(self.ends.sum(0)).max())

    def extremes(self, thick: "ThickUnit", left: NDArray) -> NDArray:
        """Motions (2, n, 15, 4, 4) from the print to where the free end is farthest, either way.

        All units give way the same way; ``thick`` and ``left`` as `tube_slop` had them.
        """
        row = int(np.abs(self.ends.sum(0)).max(-1).argmax())
        return np.stack(
            [print_stack.motions(thick, 1.0, left, self.poses[:, row, side]) for side in (0, 1)]
        )

    @property
    def usual(self) -> float:
        """Root mean square of the free end's motion, mm, if units stand anywhere independently."""
        half = (self.ends[..., 1] - self.ends[..., 0]) / 2
        return float(np.sqrt((half**2 / 3).sum(0).max()))


def tube_slop(
    thick: "ThickUnit",
    layouts: "Sequence[Layout]",
    parameters: "HingeParameters",
    incoming_left: NDArray | None = None,
    progress: "Progress" = NOBODY,
) -> Slop:
    """`Slop` of a compensated `ThickUnit` whose first block is held.

    ``layouts``: of its units; ``incoming_left`` as in `tube.Tube`.
    """
    count = len(layouts)
    left = print_stack.alternating(count) if incoming_left is None else np.asarray(incoming_left)
    frames, end, directions = standing(thick, left)
    known, angles, moved, poses = {}, [], [], []
    for k, layout in enumerate(layouts):
        unit = thick[k : k + 1]
        progress.step("Free motion of the units", k / count)
        key = np.round(unit._shifts, 5).tobytes(), np.round(unit._flat, 4).tobytes()
        if key not in known:
            known[key] = _Loose(unit, layout, parameters)
        loose = known[key]
        here = rigid.inverse(frames[k])
        place, ways = rigid.apply(here, end[None])[0], directions @ here[:3, :3].T
        angles.append(loose.turns())
        reached = loose.ends(place, ways, bool(left[k]))
        moved.append(reached[0])
        poses.append(reached[1])
    return Slop(np.array(angles), np.array(moved), directions, np.array(poses))


def no_slop(thick: "ThickUnit", incoming_left: NDArray | None = None) -> Slop:
    """The `Slop` of a tube whose hinges have no play."""
    poses = thick.poses(1.0).reshape(-1, len(BODIES), 4, 4)
    count = len(poses)
    left = print_stack.alternating(count) if incoming_left is None else np.asarray(incoming_left)
    nothing = np.zeros((count, 3, 2))
    everywhere = np.broadcast_to(poses[:, None, None], (count, 2, 2, *poses.shape[1:]))
    return Slop(nothing, nothing, standing(thick, left)[2], everywhere)


def standing(thick: "ThickUnit", left: NDArray) -> tuple:
    """Where a deployed tube stands.

    Frames (n, 4, 4) that carry each unit's poses (left contact panel at rest) into the print's
    frame, the free end (3,) and directions (3, 3), rows: across the tube in its plane, along the
    legs, along the chord.
    """
    carried = print_stack.motions(thick, 1.0, left)
    places = print_stack.frames(thick, left)
    frames = carried[:, 0] @ places  # of the left contact panel
    lines = block_lines(thick, left).mean(1)
    legs = frames[0, :3, :3] @ _leg(thick[0:1])
    chord = lines[-1] - lines[0]
    chord = chord - (chord @ legs) * legs
    chord = chord / np.linalg.norm(chord)
    return frames, lines[-1], np.stack([np.cross(legs, chord), legs, chord])


def _leg(thick: "ThickUnit") -> NDArray:
    flat = thick.unit.flat.reshape(-1, 10, 3)[0]
    leg = flat[INDEX["B_upper"]] - flat[INDEX["B_lower"]]
    return leg / np.linalg.norm(leg)


class _Loose:
    """One deployed unit of rigid panels, to be pulled; all in its left contact panel's frame."""

    def __init__(self, thick: "ThickUnit", layout: "Layout", parameters: "HingeParameters") -> None:
        # rigid bodies feel only the outermost places of a hinge
        self.unit = bare_unit(thick, outermost(contacts([layout], parameters)))
        poses = thick.states(np.array([[1.0]]))[0, 0].copy()
        poses[:, :3, 3] *= thick.scale
        self.poses = poses
        self.known: NDArray | None = None
        flat = thick.unit.flat.reshape(-1, 10, 3)[0]
        self.middle = np.array([flat[INDEX[v]] for v in ("A_right_upper", "B_lower")]).mean(0)
        along = flat[INDEX["A_right_upper"]] - flat[INDEX["B_upper"]]
        self.along = along / np.linalg.norm(along)
        self.reach = thick.scale / 2

    def axes(self) -> NDArray:
        """Unit vectors (3, 3), rows: leg, across, tube (mean of both contact panels' normals)."""
        leg, turn = self.unit.leg, self.poses[RIGHT, :3, :3]
        normal = np.cross(leg, self.along)
        tube = normal - turn @ normal  # folded flat, both lie on each other and look away
        tube -= (tube @ leg) * leg
        tube /= np.linalg.norm(tube)
        return np.stack([leg, np.cross(tube, leg), tube])

    def turns(self) -> NDArray | None:
        """Free turns (3, 2) about `axes`, radians."""
        if self.known is None:
            self.known = np.array(
                [[self._turned(axis, sign) for sign in (-1, 1)] for axis in self.axes()]
            )
        return self.known

    def _turned(self, axis: NDArray, sign: int) -> float:
        arm = np.cross(axis, [0.3, 0.9, -0.2])
        arm /= np.linalg.norm(arm)
        turn = self.poses[RIGHT, :3, :3]
        points = self.middle + self.reach * np.array([[1], [-1]]) * (turn.T @ arm)
        force = sign * SOFT / (2 * self.reach) * np.cross(axis, arm)
        poses = self.pulled(points, np.stack([force, -force]))
        return rigid.rotation_vector(poses[RIGHT, :3, :3] @ turn.T) @ axis

    def ends(self, place: NDArray, ways: NDArray, right: bool) -> tuple[NDArray, NDArray]:
        """How far ``place`` (3,) goes along ``ways`` (3, 3), rows: (3, 2) mm, both ways, and poses.

        It goes with the right contact panel, or (not ``right``) with the left one, the right one
        held: then the same motion, back to front.
        """
        was = self.poses[RIGHT]
        point = rigid.apply(rigid.inverse(was), place[None])
        lever = max(float(np.linalg.norm(point - self.middle)), self.reach)
        found, poses = np.zeros((3, 2)), np.zeros((2, 2, *self.poses.shape))
        for row, way in enumerate(ways[:2]):
            for column, sign in enumerate((-1, 1)):
                force = (sign if right else -sign) * SOFT / lever * way
                poses[row, column] = self.pulled(point, force[None])
                now = poses[row, column][RIGHT]
                motion = now @ rigid.inverse(was) if right else was @ rigid.inverse(now)
                found[row, column] = (rigid.apply(motion, place[None])[0] - place) @ way
        return found, poses

    def pulled(self, points: NDArray, forces: NDArray) -> NDArray:
        """Poses under forces on points of the right contact panel."""
        rest = least(self.unit, 1.0, start(self.unit, self.poses), pull=Pull(points, forces),
                     stages=_STAGES)  # fmt: skip
        return rest.state.poses
