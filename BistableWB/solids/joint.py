# SPDX-License-Identifier: LGPL-2.1-or-later
"""Part of a tube as a print of its own, as solids of the kernel."""

from typing import TYPE_CHECKING, Any

from ..origami.hinges.joints import DOWEL, DOWEL_PLAY, dowel_places
from ..origami.hinges.parts import part_drawn
from ..origami.progress import NOBODY
from .tube import bodies_of

if TYPE_CHECKING:
    from ..origami.hinges.parameters import HingeParameters
    from ..origami.progress import Progress
    from ..origami.thick.linkage import ThickUnit
    from .tube import Body

__all__ = ["DOWEL", "DOWEL_PLAY", "dowel_places", "part_bodies"]


def part_bodies(
    thick: "ThickUnit",
    parameters: "HingeParameters",
    first: int,
    last: int,
    incoming_left: Any = None,
    progress: "Progress" = NOBODY,
) -> "list[Body]":
    """Bodies of units ``first`` … ``last``: `parts.part_drawn` as solids."""
    return bodies_of(part_drawn(thick, parameters, first, last, incoming_left, progress).bodies)
