# SPDX-License-Identifier: LGPL-2.1-or-later
"""A whole tube of thick panels: placed so that the *compensated* units follow the curve.

The rule of hinges.md 5 leaves room for thickness; compensation then shifts hinge axes by some
tenths of a millimetre, which changes how a unit's two blocks stand to each other. Their distance
and their angle are measured on the compensated units and given back to placement and units until
both agree; for what is left the blocks are shifted in their planes (`blocks.laid`).
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..curves.placement import Placement
from ..progress import NOBODY
from ..units.creases import BODIES
from ..units.tube import Tube, Tuning
from . import blocks, print_stack
from .linkage import ThickUnit

if TYPE_CHECKING:
    from ..progress import Progress

_ROUNDS = 6
_ANGLE_AGREED = 1e-7  # an error that a long tube adds up
_LENGTH_AGREED = 1e-5  # of ‖AB‖: what is left, shifts take up


@dataclass(frozen=True)
class ThickTube:
    """Placement, zero-thickness `tube.Tube` and `linkage.ThickUnit` batch of one thick tube.

    ``placement`` is None for a unit that stands by itself; ``lift`` (mm): of its flat units from
    the bed, on what the lower end of the print has.
    """

    tube: Tube
    thick: ThickUnit
    placement: Placement | None = None
    lift: float = 0.0

    @property
    def is_closed(self) -> bool:
        """Whether its last block is its first when deployed."""
        return self.placement is not None and self.placement.closed

    def motions(self, opening: float) -> NDArray:
        """Motions (n, 15, 4, 4) of all bodies from the flat print to ``opening``.

        The flat print stands on the bed, or ``lift`` higher; deployed,
        the blocks' mid-lines lie on the placement; in between the tube moves from one place to the
        other.
        """
        found = print_stack.motions(self.thick, opening, self.tube.incoming_left)
        up = np.eye(4)
        up[2, 3] = self.lift
        goal = up if self.placement is None else self.onto_curve()
        return rigid.between(up, goal, opening) @ found @ rigid.inverse(up)

    def onto_curve(self) -> NDArray:
        """Motion (4, 4) that lays the deployed blocks' mid-lines best on the placement."""
        lines = block_lines(self.thick, self.tube.incoming_left)
        placed: Any = self.placement
        return rigid.fit(lines.reshape(-1, 3), placed.segments.reshape(-1, 3))

    def part(self, first: int, last: int) -> "ThickTube":
        """The tube of units ``first`` … ``last``, counted from 0; itself if these are all."""
        if (first, last) == (0, len(self.tube) - 1):
            return self
        units = slice(first, last + 1)
        placed = self.placement and self.placement.between(first, last)
        return ThickTube(self.tube[units], self.thick[units], placed)

    def deviation(self) -> float:
        """Largest distance (mm) of a deployed block's mid-line from its place on the curve."""
        if self.placement is None:
            return 0.0
        lines = block_lines(self.thick, self.tube.incoming_left)
        on_curve = rigid.apply(self.onto_curve(), lines).mean(1)
        return float(np.linalg.norm(on_curve - self.placement.midpoints, axis=1).max())


def thick_tube(
    place: Callable[..., Any],
    make_tube: Callable[..., Any],
    face_thickness: float,
    gap_between_planes: float,
    compensate: bool = True,
    progress: "Progress" = NOBODY,
    preload: Callable[[ThickUnit], ThickUnit] | None = None,
) -> "ThickTube":
    """Place, make and compensate a whole tube so that it follows the curve when deployed.

    ``place(tuning)`` → `Placement` and ``make_tube(placement, tuning)`` → `Tube` with a
    `tube.Tuning`; thicknesses in mm. Without ``compensate`` the units stay as they are. The tube
    has as many units as the first placement, fewer only where the curve ends before the last.
    ``progress``: a `Progress`; ``preload(thick)``: preloads compensated units, or None.
    Returns a `ThickTube`.
    """
    tuning, count = Tuning(), None
    for done in range(_ROUNDS):
        progress.step("Thick panels…", done / _ROUNDS)
        placed = place(tuning)
        count = count or len(placed)
        placed = placed.between(0, count - 1)
        tube = make_tube(placed, tuning)
        thick = ThickUnit(tube.unit, face_thickness, gap_between_planes)
        if not compensate:
            return ThickTube(tube, thick, placed)
        thick = thick.compensated()
        thick = preload(thick) if preload else thick
        goals = blocks.wanted_steps(placed)
        tuning, agreed = _tuned(tuning, placed, blocks.steps(thick, tube.incoming_left), goals)
        if agreed:
            break
    return ThickTube(tube, blocks.laid(thick, tube.incoming_left, goals), placed)


def _tuned(tuning: Tuning, placed: Placement, here: NDArray, goals: NDArray) -> tuple[Tuning, bool]:
    """Next `Tuning` for steps ``here`` instead of the goals, and whether it is as good as this."""
    count = len(placed)
    distance, climb = blocks.distances(goals)
    further = (blocks.distances(here)[0] - distance) / (2 * climb)
    wider = np.sin(blocks.angles(goals) / 2) - np.sin(blocks.angles(here) / 2)
    tuned = Tuning(
        tuning.fitted(tuning.extra, count) + further,
        tuning.fitted(tuning.sines, count) + wider,
        placed,
    )
    agreed = (
        np.abs(wider).max() < _ANGLE_AGREED
        and np.abs(further).max() < _LENGTH_AGREED * placed.edge_length
    )
    return tuned, agreed


def block_lines(thick: ThickUnit, incoming_left: NDArray) -> NDArray:
    """Mid-lines (n + 1, 2, 3) of all blocks of the deployed tube, chained from the first.

    Block k's line runs from the joint with the unit before to the joint with the next, in the
    print frame carried by `print_stack.motions`; the ends lie in the blocks' mid-planes.
    """
    flat = thick.lines.reshape(-1, 2, 2, 3)
    carried = print_stack.motions(thick, 1.0, incoming_left)
    carried = carried @ print_stack.frames(thick, incoming_left)[:, None]
    lines = []
    for k, left in enumerate(incoming_left):
        entry, leave = print_stack.contact_names(left)
        lines.append(rigid.apply(carried[k, BODIES.index(entry)], flat[k, 0 if left else 1]))
    last = flat[-1, 1 if left else 0, ::-1]
    lines.append(rigid.apply(carried[-1, BODIES.index(leave)], last))
    return np.array(lines)
