# SPDX-License-Identifier: LGPL-2.1-or-later
"""A whole tube of thick panels: placed so that the *compensated* units follow the curve.

The rule of ``hinges.md`` 5 leaves room for thickness; compensation then shifts hinge axes by some
tenths of a millimetre, which changes how a unit's two blocks stand to each other. That change is
measured on the compensated units and given back to placement and units until all agree.
"""

from dataclasses import dataclass

import numpy as np

from . import print_stack, rigid
from .creases import BODIES, INDEX
from .linkage import ThickUnit
from .placement import Placement
from .tube import Tube, Tuning

_ROUNDS = 6
_AGREED = 1e-7  # of ‖AB‖, or radians


@dataclass(frozen=True)
class ThickTube:
    """Placement, zero-thickness `tube.Tube` and `linkage.ThickUnit` batch of one thick tube.

    ``placement`` is None for a unit that stands by itself.
    """

    tube: Tube
    thick: ThickUnit
    placement: Placement | None = None

    def motions(self, opening):
        """Motions (n, 15, 4, 4) of all bodies from the flat print to ``opening``.

        The flat print stands on the bed; deployed, the blocks' mid-lines lie on the placement; in
        between the tube moves from one place to the other.
        """
        found = print_stack.motions(self.thick, opening, self.tube.incoming_left)
        if self.placement is None:
            return found
        return rigid.between(np.eye(4), self.onto_curve(), opening) @ found

    def onto_curve(self):
        """Motion (4, 4) that lays the deployed blocks' mid-lines best on the placement."""
        lines = block_lines(self.thick, self.tube.incoming_left, self._end)
        return rigid.fit(lines.reshape(-1, 3), self.placement.segments.reshape(-1, 3))

    def part(self, first, last):
        """The tube of units ``first`` … ``last``, counted from 0; itself if these are all."""
        if (first, last) == (0, len(self.tube) - 1):
            return self
        units = slice(first, last + 1)
        tube = Tube(self.tube.unit[units], self.tube.frames[units], self.tube.incoming_left[units])
        placed = self.placement and self.placement.between(first, last)
        return ThickTube(tube, self.thick[units], placed)

    def deviation(self):
        """Largest distance (mm) of a deployed block's mid-line from its place on the curve."""
        if self.placement is None:
            return 0.0
        lines = block_lines(self.thick, self.tube.incoming_left, self._end)
        on_curve = rigid.apply(self.onto_curve(), lines).mean(1)
        return float(np.linalg.norm(on_curve - self.placement.midpoints, axis=1).max())

    @property
    def _end(self):
        return _traced(self.tube)


def _traced(tube):
    """The line of the strip that follows the curve: the middle, on a sphere the outer base."""
    return "middle" if tube.unit.omega is None else "upper"


def thick_tube(place, make_tube, face_thickness, gap_between_planes, compensate=True):
    """Place, make and compensate a whole tube so that it follows the curve when deployed.

    ``place(tuning)`` → `Placement` and ``make_tube(placement, tuning)`` → `Tube` with a
    `tube.Tuning`; thicknesses in mm. Without ``compensate`` the units stay as they are. The tube
    has as many units as the first placement, fewer only where the curve ends before the last.
    Returns a `ThickTube`.
    """
    tuning, count = Tuning(), None
    for _ in range(_ROUNDS):
        placed = place(tuning)
        count = count or len(placed)
        placed = placed.between(0, count - 1)
        tube = make_tube(placed, tuning)
        thick = ThickUnit(tube.unit, face_thickness, gap_between_planes)
        if not compensate:
            break
        thick = thick.compensated()
        tuning, missing = _tuned(tuning, placed, thick, _traced(tube))
        if missing < _AGREED:
            break
    return ThickTube(tube, thick, placed)


def _tuned(tuning, placed, thick, end):
    """Next `Tuning`, and how far the units are from the placement (in ‖AB‖ and radians)."""
    here, there = _steps(thick, end), _wanted(placed)
    missing = here - there
    missing[:, 0] /= placed.edge_length
    count = len(placed)
    fitted = [tuning.fitted(v, count) for v in (tuning.extra, tuning.sines, tuning.cotangents)]
    half = placed.thetas / 2
    rule = placed.pitch * (1 + np.cos(half)) + placed.edge_length / 2 * np.sin(half)
    tuned = Tuning(here[:, 0] - rule, fitted[1] - missing[:, 1], fitted[2] - missing[:, 2])
    return tuned, np.abs(missing).max()


def _steps(thick, end):
    """How each unit leads from one block to the next when deployed: (n, 3).

    Half the distance of the blocks' midpoints (mm), and the direction from one to the other seen
    from the first block: its part along A-B, and the slope −(part along the legs) / (part along
    A-B) of the line in which the unit's mid-plane cuts the block.
    """
    lines = thick.block_lines(1.0, end).reshape(-1, 2, 2, 3)
    middles = lines.mean(2)
    step = middles[:, 1] - middles[:, 0]
    distance = np.linalg.norm(step, axis=1)
    along = (lines[:, 0, 1] - lines[:, 0, 0]) / thick.unit.edge_length
    up = np.cross(along, [0, 1.0, 0])  # the left block keeps its flat plane y = const
    up *= np.sign(up[:, 2:])
    sine, rise = (step * along).sum(1) / distance, (step * up).sum(1) / distance
    return np.stack([distance / 2, sine, -rise / sine], 1)


def _wanted(placed):
    """The same as `_steps` asks of a placement."""
    step = np.diff(placed.midpoints, axis=0)
    distance = np.linalg.norm(step, axis=1)
    rise = (step * placed.legs[:-1]).sum(1) / distance
    sine = np.sin(placed.thetas / 2)
    return np.stack([distance / 2, sine, -rise / sine], 1)


def block_lines(thick, incoming_left, end="middle"):
    """Mid-lines (n + 1, 2, 3) of all blocks of the deployed tube, chained from the first.

    Block k's line runs from the joint with the unit before to the joint with the next, in the
    print frame carried by `print_stack.motions`; the ends lie in the blocks' mid-planes.
    """
    flat = thick.unit.flat.reshape(-1, *thick.unit.flat.shape[-2:])
    carried = print_stack.motions(thick, 1.0, incoming_left)
    carried = carried @ print_stack.frames(thick, incoming_left)[:, None]
    lines = []
    for k, left in enumerate(incoming_left):
        entry, leave = print_stack.contact_names(left)
        a, b = _line(flat[k], entry, thick.pitch, end)
        lines.append(rigid.apply(carried[k, BODIES.index(entry)], np.stack([a, b])))
    a, b = _line(flat[-1], leave, thick.pitch, end)
    lines.append(rigid.apply(carried[-1, BODIES.index(leave)], np.stack([b, a])))
    return np.array(lines)


def _line(flat, contact, pitch, end):
    """A and B of a contact panel's line in the mid-plane of its block (unit's flat frame)."""
    side = contact.split("_")[1]
    ends = ("upper", "lower") if end == "middle" else (end,)
    lift = np.array([0, (-2 if side == "left" else 2) * pitch, 0])
    return (
        np.mean([flat[INDEX[f"{corner}_{e}"]] for e in ends], 0) + lift
        for corner in (f"A_{side}", "B")
    )
