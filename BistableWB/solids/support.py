# SPDX-License-Identifier: LGPL-2.1-or-later
"""The soluble support between the panels of a flat-folded print, as one body of many prisms."""

import Part

from ..origami import print_stack
from ..origami.support_plan import joint_prisms, unit_prisms
from . import brep
from .tube import Body, in_print_plan, moved, tube_layouts


def support_body(thick, parameters, incoming_left=None):
    """`Body` "support" (material "support") of a tube in the print frame: a compound of prisms.

    Arguments as for `tube.tube_bodies`. Prisms fill the gaps between stacked panels, touch them,
    and keep the clearance from every barrel; what overhangs outside the stack is the slicer's.
    """
    layouts = tube_layouts(thick, parameters)
    places = print_stack.frames(thick, incoming_left)
    if incoming_left is None:
        incoming_left = print_stack.alternating(len(layouts))
    prisms = []
    for k, layout in enumerate(layouts):
        for corners, low, high in unit_prisms(layout, parameters):
            prisms.append(moved(_prism(corners, low, high), places[k]))
        if k + 1 < len(layouts):
            prisms += _between(layouts, places, incoming_left, k, parameters)
    return Body("support", Part.makeCompound(prisms), 0, (), "support")


def _prism(corners, low, high):
    face = brep.polygon([brep.at(p, low) for p in corners])
    return face.extrude(brep.Vector(0, high - low, 0))


def _between(layouts, places, incoming_left, k, parameters):
    """Prisms between the triangles of unit k and of the unit on it."""
    leave = "right" if incoming_left[k] else "left"
    entry = "left" if incoming_left[k + 1] else "right"
    below, above = (
        [layout.plates[f"primary_{side}_{end}"].core for end in ("upper", "lower")]
        for layout, side in ((layouts[k], leave), (layouts[k + 1], entry))
    )
    plans = joint_prisms(below, above, lambda core, i: in_print_plan(core, places[k + i]))
    low = (4 * k + 4) * parameters.pitch - parameters.gap_between_planes
    up = brep.Vector(0, 0, parameters.gap_between_planes)
    return [
        brep.polygon([brep.Vector(p.real, p.imag, low) for p in corners]).extrude(up)
        for corners in plans
    ]
