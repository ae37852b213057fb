# SPDX-License-Identifier: LGPL-2.1-or-later
"""Part of a tube as a print of its own: half a block at either cut, with holes for dowels.

A block is cut in the middle of the gap between its two contact panels. Each half is the contact
panel with half the filler on it, t + g/2 thick; two through holes in both take pieces of filament
as dowels. They lie off the middle, so that the halves fit together one way only.
"""

from math import pi

import numpy as np
import Part
from FreeCAD import Vector

from ..origami import plan, print_stack
from . import brep
from .tube import BLOCK_INSET, in_print_plan, tube_bodies, tube_layouts

DOWEL = 1.75  # mm, the diameter of filament
DOWEL_PLAY = 0.2  # mm that a hole is wider
DOWEL_PLACES = (0.2, 0.7)  # shares of the filler's length


def part_bodies(thick, parameters, first, last, incoming_left=None, progress=None):
    """Bodies of units ``first`` … ``last`` of a tube on the bed, with half blocks at the cuts.

    Arguments as for `tube.tube_bodies`; `checks.bed.split` tells into which parts a bed splits a
    tube. Names and units count from the first unit of the part.
    """
    count = len(thick)
    left = print_stack.alternating(count) if incoming_left is None else np.asarray(incoming_left)
    part, own = thick[first : last + 1], left[first : last + 1]
    bodies = tube_bodies(part, parameters, own, progress)
    layouts = tube_layouts(thick, parameters)
    whole, here = print_stack.frames(thick, left), print_stack.frames(part, own)
    for below, unit, upwards in ((first - 1, first, False), (last, last, True)):
        if not 0 <= below < count - 1:
            continue
        filler = _filler(layouts, whole, left, below)
        k = unit - first
        move = here[k] @ np.linalg.inv(whole[unit])
        corners, dowels = (_moved(points, move) for points in (filler, dowel_places(filler)))
        member = k, print_stack.contact_names(left[unit])[upwards]
        index = next(i for i, body in enumerate(bodies) if member in body.members)
        face = 4 * parameters.pitch * k  # of the contact panel, away from its unit
        face += 4 * parameters.pitch - parameters.gap_between_planes if upwards else 0.0
        shape = half_block(bodies[index].shape, corners, dowels, face, parameters, upwards)
        bodies[index] = bodies[index]._replace(shape=shape, name=f"half_{bodies[index].name}")
    lift = Vector(0, 0, parameters.gap_between_planes / 2 if first > 0 else 0)
    return [body._replace(shape=body.shape.translated(lift)) for body in bodies]


def half_block(shape, corners, dowels, face, parameters, upwards):
    """A contact panel with half of a block's filler on it and through holes for dowels.

    ``shape``: the panel in the print frame, its free side at height ``face`` (mm); ``corners`` of
    the filler and ``dowels``: plan points x + i y; ``upwards``: the other half lies above.
    """
    half, thickness = parameters.gap_between_planes / 2, parameters.face_thickness
    sink = thickness / 2  # the filler reaches into the panel that it is fused to
    low = face - sink if upwards else face - half
    added = brep.polygon([Vector(p.real, p.imag, low) for p in corners])
    body = shape.fuse(added.extrude(Vector(0, 0, half + sink)))
    radius = (DOWEL + DOWEL_PLAY) / 2
    holes = [
        Part.makeCylinder(radius, 4 * thickness, Vector(p.real, p.imag, face - 2 * thickness))
        for p in dowels
    ]
    body = body.cut(Part.makeCompound(holes))
    taken = len(holes) * pi * radius**2 * (thickness + half)
    volume = shape.Volume + abs(plan.area(corners)) * half - taken
    if len(body.Solids) != 1 or abs(body.Volume - volume) > brep.VOLUME_TOLERANCE * volume:
        raise RuntimeError("A half block did not become one solid.")
    return body.Solids[0]


def dowel_places(corners):
    """Plan points of the dowels on the longer middle line of a filler's corners (x + i y)."""
    n = len(corners)
    start = max(range(n), key=lambda i: abs(corners[(i + 1) % n] - corners[i]))
    along = plan.unit(corners[(start + 1) % n] - corners[start])
    middle = sum(corners) / n
    reach = [plan.dot(p - middle, along) for p in corners]
    low, high = min(reach), max(reach)
    return [middle + (low + share * (high - low)) * along for share in DOWEL_PLACES]


def _filler(layouts, places, left, below):
    """Corners of the filler of the block above unit ``below``, in the whole tube's print plan."""
    names = (
        print_stack.contact_names(left[below])[1],
        print_stack.contact_names(left[below + 1])[0],
    )
    cores = [
        in_print_plan(layouts[k].plates[name].core, places[k])
        for k, name in zip((below, below + 1), names, strict=True)
    ]
    return plan.intersection(*cores, inset=BLOCK_INSET)


def _moved(points, move):
    return [complex(*(move[:2, :2] @ (p.real, p.imag) + move[:2, 3])) for p in points]
