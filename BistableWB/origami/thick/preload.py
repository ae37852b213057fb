# SPDX-License-Identifier: LGPL-2.1-or-later
"""Preload: hinge axes shifted so that the cones of a deployed unit bear, and it does not wobble.

Compensation lets a deployed unit close exactly: then every cone stands in the middle of its play,
and the unit is loose. Shifted a little further, the axes P–C' turned and the axes P–B moved apart,
the deployed unit closes only with all of that play: its cones bear, on all sides, and hold it. The
flat print does not change, it is where the axes are defined. Of the two senses of that shift this
one pulls the barrels of double hinges apart, where the other lets them collide, and adds little to
the misfit on the way, where knuckles would break (docs/theory/hinges.md 4).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .. import rigid
from ..units.creases import CREASES
from .linkage import ThickUnit

# Shifts of start and end of an axis across it, in gap lengths; mirrored in the lower sub-unit.
_SHIFTS = {"PC": (-2.25, 1.5), "PB": (1.5, 1.5), "AC": (0.75, 0.0), "AP": (-0.75, 0.0)}


def _pattern() -> NDArray:
    pattern = np.zeros((len(CREASES), 2))
    for k, crease in enumerate(CREASES):
        kind, *_, end = crease.name.split("_")
        pattern[k] = np.multiply(1 if end == "upper" else -1, _SHIFTS.get(kind, (0.0, 0.0)))
    return pattern


PATTERN = _pattern()


_LATE = 8  # power of the opening: 0.02 of the motion to rest are left at 60 %, 0.4 at 90 %


@dataclass(frozen=True)
class Rest:
    """How n preloaded units stand when they are deployed.

    ``amounts`` (n,): gap that each takes up, mm; ``moved`` (n, 15, 4, 4): from the poses of least
    squared misfit to those of rest, in the bodies' own frames, lengths in edge lengths;
    ``pressed`` (n,): how deep cones then press into their recesses, mm.
    """

    amounts: NDArray
    moved: NDArray
    pressed: NDArray

    def take(self, units: NDArray | slice) -> "Rest":
        """The rest of some units of the batch."""
        return Rest(self.amounts[units], self.moved[units], self.pressed[units])

    def on(self, poses: NDArray, fractions: NDArray) -> NDArray:
        """Poses (n, m, 15, 4, 4) at openings (n or 1, m) that come to rest at the deployed state.

        What the bodies move by for that comes at the end of the way: before, where a unit snaps,
        poses of least squares overlap less.
        """
        share = np.clip(fractions, 0, 1)[..., None] ** _LATE
        return poses @ rigid.between(np.eye(4), self.moved[:, None], share)


def preloaded(thick: ThickUnit, preload: float | NDArray) -> ThickUnit:
    """A compensated `ThickUnit` whose deployed cones bear.

    ``preload``: gap that it takes up, mm, one number or one a unit (n,): at the hinges' gap length
    about all of it.
    """
    amounts = np.asarray(preload, float)
    return thick.shifted(amounts[..., None, None] * PATTERN) if amounts.any() else thick


def without(thick: ThickUnit) -> ThickUnit:
    """The compensated `ThickUnit` that a preloaded and resting one was made of."""
    return thick if thick.rest is None else preloaded(thick, -thick.rest.amounts)
