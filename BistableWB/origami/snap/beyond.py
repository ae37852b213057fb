# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a deployed unit bears in the way of opening further (docs/theory/hinges.md 4).

Opened beyond its deployed state a unit has no stop: its torque rises until a knuckle breaks or its
panels buckle. Both are found by going on in small steps, each state searched from the last one. A
long step may land behind the buckling, where little is borne; so the energy has to grow by what
the torque does on the way, or the step is halved.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from .. import rigid
from ..progress import NOBODY
from .minimum import State, least

if TYPE_CHECKING:
    from ..progress import Progress
    from ..thick.linkage import ThickUnit
    from .minimum import ElasticUnit, Rest

_MOST = 1.12  # opening beyond which nobody asks
_STEP, _LEAST, _PATIENT = 0.01, 0.00125, 150
_FALLEN, _NOISE = 0.95, 2.0  # of the largest torque, and N·mm: less is the search's own noise
_WORK = 0.25, 0.02  # of the work and of the energy, by which they may differ: a trapezium's error
_NOTHING = 0.1  # N·mm of energy: within the hinges' play


def bears_beyond(
    unit: "ElasticUnit",
    thick: "ThickUnit",
    deployed: "Rest",
    share: "Callable[[Rest, float], float]",
    clearance: float = 1.0,
    progress: "Progress" = NOBODY,
) -> float:
    """Largest torque, N·mm, before a knuckle breaks or panels buckle, from the ``deployed`` rest.

    ``share``: stress / strength of the hardest worked knuckle at a rest and its opening;
    ``clearance`` as of `minimum.least`.
    """
    here, at, step = deployed, 1.0, _STEP
    worked, most = share(deployed, 1.0), max(deployed.torque, 0.0)
    while at < _MOST and worked < 1:
        progress.step(fraction=(at - 1) / (_MOST - 1))
        there = _next(unit, thick, here, at, at + step, clearance)
        if not (there.found and _same_branch(unit, here, there, step)):
            step /= 2
            if step < _LEAST:
                return most
            continue
        stress = share(there, at + step)
        torque = there.torque
        if stress > 1 > worked:  # on the way
            torque = here.torque + (1 - worked) / (stress - worked) * (torque - here.torque)
        if torque < _FALLEN * most - _NOISE:
            return most
        most = max(most, torque)
        here, at, worked, step = there, at + step, stress, min(2 * step, _STEP)
    return most


def _next(
    unit: "ElasticUnit", thick: "ThickUnit", here: "Rest", at: float, there: float, clearance: float
) -> "Rest":
    """The rest at an opening, from the last one moved as rigid units move."""
    poses = thick.states(np.array([[at, there]]))[0]
    poses[..., :3, 3] *= thick.scale
    moved = poses[1] @ rigid.inverse(poses[0]) @ here.state.poses
    return least(unit, there, State(moved, here.state.modes), clearance, rounds=_PATIENT)


def _same_branch(unit: "ElasticUnit", here: "Rest", there: "Rest", step: float) -> bool:
    """Whether the energy grew by the work of the torques."""
    work = abs(unit.turn) * step * (here.torque + there.torque) / 2
    error, least_error = _WORK
    allowed = error * abs(work) + least_error * here.energy + _NOTHING
    return abs(there.energy - here.energy - work) < allowed
