# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much preload makes a deployed unit's cones bear, and how the unit then stands.

`thick.preload` shifts hinge axes; here the cones say how far. The clearance that rigid bodies need
in the deployed state, as a factor k on what their hinges have, grows with the shift: at k = 1 the
cones just bear, and beyond they press into their recesses, by (k − 1) of the clearance. The poses
of least k are those at rest: nowhere do bodies press deeper than they must (docs/theory/hinges.md
4). Lengths mm, but edge lengths inside.
"""

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..hinges.bodies import tube_layouts
from ..hinges.parameters import HingeParameters
from ..thick.linkage import ThickUnit
from ..thick.preload import Rest, preloaded
from .clearance import least_clearance
from .contact import contacts, outermost

# Factor on the clearance: enough that nothing moves freely, little enough that nothing breaks.
PRESS = 1.3
MOST = 1.5  # of the gap length
_FIRST = 1.0  # of the gap length: about what it comes to
_FEW = 3  # knuckles, which do not hold
_ROUNDS = 3  # the clearance that is needed is nearly linear in the amount
_SETTLED = 2  # calls after which preload and rest are kept


class Preloader:
    """Preloads the compensated units of one tube, again and again while it is fitted to its curve.

    ``amount``: gap that all take up, mm; None: each as much as makes its cones bear (`PRESS`), and
    nothing where `holds_the_ends` is not.
    ``hinges``: `HingeParameters`, or None: then nothing is known of how units stand, and an
    amount must be given. What is found at the first two calls is kept: later ones change a unit by
    less than matters.
    """

    def __init__(self, amount: float | None, hinges: HingeParameters | None = None) -> None:
        self.amount, self.hinges = amount, hinges
        self.rest: Rest | None = None
        self.calls = 0

    def __call__(self, thick: ThickUnit) -> ThickUnit:
        """The units preloaded, at rest when deployed."""
        if self.amount == 0 or (self.amount is None and not self._holds_the_ends()):
            return thick
        if self.hinges is None:
            return preloaded(thick, self.amount or 0.0)
        self.calls += 1
        if self.rest is None or len(self.rest.amounts) != len(thick) or self.calls <= _SETTLED:
            self.rest = rest_of(thick, self.hinges, self.amount, self.rest)
        return preloaded(thick, self.rest.amounts).resting(self.rest)

    def _holds_the_ends(self) -> bool:
        """Whether cones sit near the ends of hinges, at the corners of panels."""
        return self.hinges is None or holds_the_ends(self.hinges)


def holds_the_ends(hinges: HingeParameters) -> bool:
    """Whether automatic preload is for such hinges.

    Three knuckles have their cones a third of the hinge away from its ends: unless panels press
    into each other by half a millimetre they bear nothing. Five or more (0.1 to 0.25 mm), or
    knuckles of a width, hold.
    """
    return hinges.segment_width > 0 or hinges.segmentations > _FEW


def rest_of(
    thick: ThickUnit,
    hinges: HingeParameters,
    amount: float | None = None,
    known: Rest | None = None,
) -> Rest:
    """`Rest` of compensated units with a preload ``amount`` (mm), or as much as each needs.

    ``known``: that of units nearly the same.
    """
    gap = hinges.gap_length
    amounts = np.full(len(thick), _FIRST * gap if amount is None else amount)
    alike = known is not None and len(known.amounts) == len(thick)
    if known is not None and alike and amount is None:
        amounts = known.amounts
    for _ in range(0 if amount is not None else 1 if alike else _ROUNDS):
        needed, *_ = _pressed(preloaded(thick, amounts), hinges)
        amounts = np.clip(amounts * PRESS / np.maximum(needed, PRESS / 4), 0, MOST * gap)
    needed, before, after = _pressed(preloaded(thick, amounts), hinges)
    return Rest(amounts, rigid.inverse(before) @ after, np.maximum(needed - 1, 0) * gap)


def _pressed(thick: ThickUnit, hinges: HingeParameters) -> tuple[NDArray, NDArray, NDArray]:
    """Factor (n,) on the clearance that the deployed state needs; poses of least squares, of it."""
    held = outermost(contacts(tube_layouts(thick, hinges), hinges)).scaled(1 / thick.scale)
    deployed = np.ones((1, 1))
    poses = thick.states(deployed)[:, 0]
    needed, _, after = least_clearance(held, thick.closures(deployed), poses)
    return needed, poses, after
