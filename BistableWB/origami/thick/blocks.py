# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the two contact blocks of a thick unit stand to each other, and where they should stand.

A block's frame: origin in the middle of its mid-line, x along it from the joint with the unit
before to the joint with the next, z normal to the block, towards the next unit. A *step* leads from
the frame of the block before a unit to that of the block after it.

Two planes differ by nothing but their angle. So once that angle is right, a unit makes any step if
each block may turn and shift in its own plane (`laid`): by tenths of a millimetre, where the curve
climbs along the legs by up to twice the pitch. So much the contact panels of neighbouring units
then differ.
"""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..curves.bezier import normalised
from .closure import RIGHT

if TYPE_CHECKING:
    from ..curves.placement import Placement
    from .linkage import ThickUnit


def wanted_steps(placed: "Placement") -> NDArray:
    """Steps (n, 4, 4) that a `placement.Placement` asks of its units."""
    x = normalised(placed.reaches)
    travel = np.diff(placed.midpoints, axis=0)
    travel = np.concatenate([travel, travel[-1:]])
    z = normalised(np.cross(x, placed.legs))
    z *= np.sign((z * travel).sum(1, keepdims=True))
    frames = _frames(placed.midpoints, x, z)
    return rigid.inverse(frames[:-1]) @ frames[1:]


def steps(thick: "ThickUnit", incoming_left: NDArray) -> NDArray:
    """Steps (n, 4, 4) of the deployed units of a `ThickUnit`."""
    return _steps(thick, _blocks(thick, incoming_left), incoming_left)


def angles(found: NDArray) -> NDArray:
    """Angles (n,) between the two blocks of steps."""
    return np.arctan2(np.hypot(found[:, 0, 2], found[:, 1, 2]), found[:, 2, 2])


def distances(found: NDArray) -> tuple:
    """How far steps lead across both blocks' common direction, mm, and the cosine of their climb.

    (n,) each. Where units open little, blocks would have to shift far to change this distance.
    """
    forward = found[:, :3, 2] + [0, 0, 1.0]
    across = (found[:, :3, 3] * normalised(forward)).sum(1)
    return across, across / np.linalg.norm(found[:, :3, 3], axis=1)


def laid(thick: "ThickUnit", incoming_left: NDArray, goals: NDArray) -> "ThickUnit":
    """The `ThickUnit` whose blocks are turned and shifted in their planes to make given steps.

    ``goals`` (n, 4, 4) are met up to what their `angles` differ; the shifts are the smallest.
    """
    blocks = _blocks(thick, incoming_left)
    here = _steps(thick, blocks, incoming_left)
    # here = Rz(first) Rx(angle) Rz(second), and likewise the goal
    first, second = (
        np.arctan2(here[:, 0, 2], -here[:, 1, 2]) - np.arctan2(goals[:, 0, 2], -goals[:, 1, 2]),
        np.arctan2(goals[:, 2, 0], goals[:, 2, 1]) - np.arctan2(here[:, 2, 0], here[:, 2, 1]),
    )
    before, after = _turn(first), _turn(second)
    missing = (before[:, :3, :3] @ goals[:, :3, 3:])[..., 0] - here[:, :3, 3]
    shifts = np.zeros((len(here), 3, 4))
    shifts[:, :2, :2] = -np.eye(2)
    shifts[..., 2:] = here[:, :3, :2]
    found = (np.linalg.pinv(shifts) @ missing[..., None])[..., 0]
    before[:, :2, 3], after[:, :2, 3] = found[:, :2], found[:, 2:]
    ends = thick.lines.reshape(-1, 2, 2, 3)
    half = np.linalg.norm(ends[:, :, 1] - ends[:, :, 0], axis=-1) / 2
    lines = np.empty_like(ends)
    for side, is_before in ((0, incoming_left), (1, ~incoming_left)):
        frames = np.where(is_before[:, None, None], blocks[:, 0] @ before, blocks[:, 1] @ after)
        # A is where the way comes from before the unit, B after it
        sign = np.where(is_before, 1, -1)[:, None]
        reach = sign * half[:, side, None] * frames[:, :3, 0]
        lines[:, side] = frames[:, None, :3, 3] + np.stack([-reach, reach], 1)
    return thick.laid(lines)


def _blocks(thick: "ThickUnit", incoming_left: NDArray) -> NDArray:
    """Frames (n, 2, 4, 4) of the blocks before and after each unit, flat."""
    ends = thick.lines.reshape(-1, 2, 2, 3)
    left = np.asarray(incoming_left, bool)[:, None, None]
    before = np.where(left, ends[:, 0], ends[:, 1])
    after = np.where(left, ends[:, 1], ends[:, 0])[:, ::-1]
    z = np.where(left[..., 0], [0, 1.0, 0], [0, -1.0, 0])
    return np.stack(
        [_frames(line.mean(1), normalised(line[:, 1] - line[:, 0]), z) for line in (before, after)],
        1,
    )


def _steps(thick: "ThickUnit", blocks: NDArray, incoming_left: NDArray) -> NDArray:
    poses = thick.poses(1.0).reshape(len(blocks), -1, 4, 4)
    right = poses[:, RIGHT] @ blocks[np.arange(len(blocks)), incoming_left.astype(int)]
    left = poses[:, 0] @ blocks[np.arange(len(blocks)), (~incoming_left).astype(int)]
    which = incoming_left[:, None, None]
    return rigid.inverse(np.where(which, left, right)) @ np.where(which, right, left)


def _frames(origins: NDArray, x: NDArray, z: NDArray) -> NDArray:
    return rigid.pose(np.stack([x, np.cross(z, x), z], -1), origins)


def _turn(angle: NDArray) -> NDArray:
    """In-plane turns (n, 4, 4)."""
    vectors = np.zeros((len(angle), 3))
    vectors[:, 2] = angle
    return rigid.pose(rigid.rotation(vectors), np.zeros((len(angle), 3)))
