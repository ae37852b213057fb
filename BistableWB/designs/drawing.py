# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of a tube of zero thickness for a report."""

import math
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from .. import pictures
from ..objects.bistable_unit import tube_of
from ..objects.triangle_placement import place_along
from ..origami.errors import phrase

if TYPE_CHECKING:
    import FreeCAD as App


def draw_unit(
    objects: "Mapping[str, App.DocumentObject]", states: bool, draw: Callable[..., Any]
) -> None:
    """Pictures of the zero-thickness tube; those of both ``states`` if they are wanted."""
    tube, sides = tube_of(objects["unit"]), None
    if "triangles" in objects:
        triangles = objects["triangles"]
        placed, geometry = place_along(triangles)
        sides = placed.sides
        gamma = math.radians(triangles.Gamma.Value)
        draw(
            "plan",
            phrase("The curve and its triangles, seen along the legs of the strips"),
            pictures.top_view,
            placed,
            geometry.curve,
            gamma,
            geometry.sphere_radius,
        )
    if states:
        draw("states", phrase("The two stable states at one scale"), pictures.both_states, tube)
    if len(tube) > 1:
        draw(
            "angles",
            phrase("Opening angle and ratio of every unit"),
            pictures.angle_chart,
            tube.unit.theta,
            tube.unit.ratio,
            sides,
        )
