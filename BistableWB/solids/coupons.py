# SPDX-License-Identifier: LGPL-2.1-or-later
"""Test prints as solids: the paper's hinged dihedral and vertex (section 5), and calibration."""

from typing import TYPE_CHECKING, Any

from ..origami.hinges.calibration import plate_drawn
from ..origami.hinges.coupons import COUPONS, coupon_drawn
from .tube import bodies_of

if TYPE_CHECKING:
    from ..origami.hinges.parameters import HingeParameters
    from .tube import Body

if TYPE_CHECKING:
    from ..origami.hinges.parameters import HingeParameters
    from .tube import Body

KINDS = COUPONS


def coupon_bodies(
    kind: str,
    parameters: "HingeParameters",
    length_x: float | None = None,
    length_y: float | None = None,
    notes: list[Any] | None = None,
    opening: float = 0.0,
) -> "list[Body]":
    """Bodies of a test print, on the bed: `coupons.coupon_drawn` as solids."""
    return bodies_of(coupon_drawn(kind, parameters, length_x, length_y, notes, opening))


def calibration_bodies(
    parameters: "HingeParameters", series: Any, notes: list[Any] | None = None
) -> Any:
    """Bodies of a calibration plate and its clearances: `calibration.plate_drawn` as solids."""
    drawn, clearances = plate_drawn(parameters, series, notes)
    return bodies_of(drawn), clearances
