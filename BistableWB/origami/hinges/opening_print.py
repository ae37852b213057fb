# SPDX-License-Identifier: LGPL-2.1-or-later
"""A flat-folded print and how its bodies move from there: what `standoffs` keep clear of."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..thick import print_stack
from ..thick.linkage import ThickUnit
from ..units.creases import BODIES
from .unit_layout import Layout, Tab

_POSES = 21  # that are solved between flat and deployed …
_BETWEEN = 2  # … and how many steps are made from one to the next


def turned(layout: Layout) -> Layout:
    """A layout upside down: its heights the other way."""
    hinges = {n: replace(hinge, height=-hinge.height) for n, hinge in layout.hinges.items()}
    plates = {
        name: replace(
            plate,
            height=-plate.height,
            ring=tuple(
                replace(item, hinge=hinges[item.hinge.name]) if isinstance(item, Tab) else item
                for item in plate.ring
            ),
        )
        for name, plate in layout.plates.items()
    }
    links = {
        name: replace(link, hinges=tuple(hinges[h.name] for h in reversed(link.hinges)))
        for name, link in layout.links.items()
    }
    return replace(layout, plates=plates, links=links, hinges=hinges)


def poses_on_the_way(thick: ThickUnit, left: NDArray) -> list[NDArray]:
    """[(m, 15, 4, 4)] of every unit: motions from its flat frame to where bodies are, on the way.

    Without the flat print itself, where stand-offs stop one layer of air below what they hold.
    """
    places, openings = print_stack.frames(thick, left), np.linspace(0, 1, _POSES)
    count = len(places)
    poses = thick.poses(openings).reshape(count, _POSES, len(BODIES), 4, 4)
    found, carried = [], np.broadcast_to(np.eye(4), (_POSES, 4, 4))
    for k in range(count):
        entry, leave = (BODIES.index(n) for n in print_stack.contact_names(left[k]))
        hang = carried @ places[k] @ np.linalg.inv(poses[k][:, entry])
        moved = hang[:, None] @ poses[k]
        carried = moved[:, leave] @ np.linalg.inv(places[k])
        steps = np.arange(1, _BETWEEN + 1) / _BETWEEN
        found.append(np.concatenate([_between(moved[:-1], moved[1:], s) for s in steps]))
    return found


def _between(first: NDArray, second: NDArray, share: float) -> NDArray:
    """Poses part of the way from one to another: turned evenly, moved straight."""
    turn = rigid.rotation_vector(second[..., :3, :3] @ np.swapaxes(first[..., :3, :3], -1, -2))
    rotations = rigid.rotation(share * turn) @ first[..., :3, :3]
    return rigid.pose(rotations, (1 - share) * first[..., :3, 3] + share * second[..., :3, 3])
