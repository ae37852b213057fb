# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the units of a tube lie on each other in the flat-folded print, and how the print unfolds.

hinges.md 1: unit k lies 4 p higher than unit k − 1, and A and B change sides from one unit to
the next, by half a turn about the leg direction. Print frame: x along A–B of the first unit, z up
the stack, y against its legs (so that the frame is right-handed); the bed is z = 0.
"""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..units.creases import BODIES

if TYPE_CHECKING:
    from .linkage import ThickUnit

# Unit's flat frame (plan x, z; stack y) → print frame (plan x, −y; stack z).
_UPRIGHT = np.array([[1.0, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])
_HALF_TURN = np.diag([-1.0, -1.0, 1.0, 1.0])


def alternating(count: int) -> NDArray:
    """(n,) bool: the unit's own left contact panel is the incoming (lower) one, for every other."""
    return np.arange(count) % 2 == 0


def contact_names(incoming_left: bool) -> tuple:
    """(incoming, outgoing) contact panel of a unit."""
    names = "contact_left", "contact_right"
    return names if incoming_left else names[::-1]


def frames(thick: "ThickUnit", incoming_left: NDArray | None = None) -> NDArray:
    """Frames (n, 4, 4) that carry each unit's flat frame into the print frame.

    ``thick``: `ThickUnit` (one unit or a batch); ``incoming_left`` (n,) bool as in `tube.Tube`,
    alternating if not given. Units lie on each other by the mid-lines of the blocks they share.
    """
    lines = thick.lines.reshape(-1, 2, 2, 3)
    count = len(lines)
    lower_left = alternating(count) if incoming_left is None else np.asarray(incoming_left, bool)
    lift = 2 * thick.pitch - thick.gap_between_planes / 2
    found = np.empty((count, 4, 4))
    below = None
    for k in range(count):
        turned = _UPRIGHT @ (np.eye(4) if lower_left[k] else _HALF_TURN)
        entry, leave = contact_names(lower_left[k])
        if below is None:
            plan = turned
        else:
            here = rigid.apply(turned, _line(lines[k], entry)[::-1])
            plan = _slide(here, below) @ turned
        found[k] = plan
        below = rigid.apply(plan, _line(lines[k], leave))
        found[k, 2, 3] = lift + 4 * thick.pitch * k
    return found


def _line(lines: NDArray, contact: str) -> NDArray:
    return lines[0 if contact == "contact_left" else 1]


def _slide(before: NDArray, after: NDArray) -> NDArray:
    """Turn about z and shift in x, y that lay a line ``before`` (2, 3) on ``after`` in plan."""
    a, b = (p[:, 0] + 1j * p[:, 1] for p in (before, after))
    turn = np.vdot(a - a.mean(), b - b.mean())
    turn /= abs(turn)
    shift = b.mean() - turn * a.mean()
    move = np.eye(4)
    move[:2, :2] = [[turn.real, -turn.imag], [turn.imag, turn.real]]
    move[:2, 3] = shift.real, shift.imag
    return move


def motions(
    thick: "ThickUnit",
    opening: float,
    incoming_left: NDArray | None = None,
    poses: NDArray | None = None,
) -> NDArray:
    """Motions (n, 15, 4, 4) of all bodies from the print to the opening (0 flat, 1 deployed).

    In the order of `creases.BODIES`; the first unit's lowest panel stays where it is, and the two
    contact panels of a block move alike. ``poses`` (n, 15, 4, 4) of the units' bodies, mm, where
    they are others than those of the opening.
    """
    place = frames(thick, incoming_left)
    count = len(place)
    lower_left = alternating(count) if incoming_left is None else np.asarray(incoming_left, bool)
    poses = thick.poses(opening) if poses is None else poses
    poses = poses.reshape(count, len(BODIES), 4, 4)
    found = np.empty_like(poses)
    carried = np.eye(4)
    for k in range(count):
        entry, leave = (BODIES.index(name) for name in contact_names(lower_left[k]))
        hang = carried @ place[k] @ np.linalg.inv(poses[k, entry])
        found[k] = hang @ poses[k] @ np.linalg.inv(place[k])
        carried = found[k, leave]
    return found
