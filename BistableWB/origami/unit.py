# SPDX-License-Identifier: LGPL-2.1-or-later
"""A bistable unit: ten vertices in two congruent states, flat and deployed.

One class, `Unit`, and three functions that make it: `plane_unit`, `sphere_unit` and
`general_unit`. `VERTICES` and `PANELS` name what it is made of.
"""

from .units.closed_forms import (
    BARS,
    IS_EDGE,
    Unit,
    bar_lengths,
    contact_radius,
    outer_radius,
    plane_unit,
    sphere_unit,
)
from .units.creases import PANELS, VERTICES
from .units.general import general_unit

__all__ = [
    "BARS", "IS_EDGE", "PANELS", "VERTICES", "Unit", "bar_lengths", "contact_radius",
    "general_unit", "outer_radius", "plane_unit", "sphere_unit",
]  # fmt: skip
