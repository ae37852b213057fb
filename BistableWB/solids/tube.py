# SPDX-License-Identifier: LGPL-2.1-or-later
"""A whole tube as it is printed: flat-folded units on each other, joined by blocks."""

from typing import NamedTuple

import numpy as np
import Part
from FreeCAD import Matrix

from ..origami import plan, print_stack
from ..origami.hinge_layout import unit_layout
from ..origami.hinge_parameters import FLEXIBLE
from ..origami.hinge_volume import plate_volume
from ..origami.strip_plan import pocket_volume, strips
from . import brep
from .cache import BodyCache
from .flexible import fingers_in, strip_solid, with_pockets
from .plates import plate_faces

# The part of a block between its two panels ends this far (mm) inside both.
BLOCK_INSET = 0.1


class Body(NamedTuple):
    """One body of the print: ``members`` are its (unit index, body name) pairs.

    ``unit`` is the index of the first of them; a block has two members, the flexible strip of a
    hinge none (it bends: no single pose holds for it), all others one. ``material``: "rigid" or
    "flexible".
    """

    name: str
    shape: Part.Shape
    unit: int
    members: tuple
    material: str = "rigid"


def tube_bodies(thick, parameters, incoming_left=None, progress=None, notes=None):
    """All bodies of a tube in the print frame (`print_stack`), n units: 15 n − (n − 1) bodies.

    ``thick``: `ThickUnit`, one or a batch, with the ``parameters``' face thickness and gap;
    ``incoming_left`` as in `tube.Tube` (alternating if not given); ``progress(done, count)`` is
    called after every unit and may raise to cancel; ``notes``: a list that takes remarks (hinges
    with fewer segments). ValueError where a hinge has no room.
    """
    layouts = tube_layouts(thick, parameters, notes)
    places = print_stack.frames(thick, incoming_left)
    count = len(layouts)
    if incoming_left is None:
        incoming_left = print_stack.alternating(count)
    contacts = [print_stack.contact_names(left) for left in incoming_left]
    cache = BodyCache(parameters)
    bodies = []
    for k, layout in enumerate(layouts):
        entry, leave = contacts[k]
        joined = ({entry} if k > 0 else set()) | ({leave} if k < count - 1 else set())
        bodies += _unit_bodies(layout, cache, joined, places[k], k)
        if k < count - 1:
            bodies.append(_block(layouts, places, contacts, k, parameters))
        if progress:
            progress(k + 1, count)
    return bodies


def _unit_bodies(layout, cache, joined, place, k):
    """Bodies of one unit without the contact panels that blocks take (``joined``)."""
    bodies = []
    for name, shape, material in layout_solids(layout, cache.parameters, cache, joined):
        members = ((k, name),) if material == "rigid" else ()
        bodies.append(Body(f"unit{k + 1:02d}_{name}", moved(shape, place), k, members, material))
    return bodies


def layout_solids(layout, parameters, cache=None, without=()):
    """(name, solid, material) of all bodies of a `hinge_plan.Layout`, in its frame.

    Plates and links, or plates with pockets and flexible strips ("strip_" and the hinge's name).
    """
    cache = cache or BodyCache(parameters)
    plates = {name: plate for name, plate in layout.plates.items() if name not in without}
    if parameters.hinge_type != FLEXIBLE:
        shapes = {name: cache.plate(plate) for name, plate in plates.items()}
        shapes |= {name: cache.link(link) for name, link in layout.links.items()}
        return [(name, shape, "rigid") for name, shape in shapes.items()]
    found = strips(layout, parameters)
    solids = []
    for name, plate in plates.items():
        left = plate_volume(plate, parameters) - pocket_volume(plate, found)
        shape = with_pockets(cache.plate(plate), fingers_in(found, name), left, name)
        solids.append((name, shape, "rigid"))
    for name, strip in found.items():
        solids.append((f"strip_{name}", strip_solid(strip, parameters), "flexible"))
    return solids


def tube_layouts(thick, parameters, notes=None):
    """`hinge_plan.Layout` of every unit; ValueErrors say which unit (counted from 1)."""
    if abs(thick.pitch - parameters.pitch) > 1e-9:
        raise ValueError(
            f"The unit's pitch is {thick.pitch:.6g} mm and the hinges' {parameters.pitch:.6g} mm: "
            "give both the same FaceThickness and GapBetweenPlanes."
        )
    layouts = []
    for k, axes in enumerate(np.asarray(thick.axes).reshape(-1, *np.shape(thick.axes)[-3:])):
        try:
            layouts.append(unit_layout(axes, parameters, thick.unit.edge_length))
        except ValueError as error:
            raise ValueError(f"Unit {k + 1}: {error}") from error
        if notes is not None:
            notes += [f"Unit {k + 1}: {note}" for note in layouts[-1].notes]
    return layouts


def moved(shape, frame):
    """Shape carried by a rigid motion (4, 4)."""
    return shape.transformed(Matrix(*(float(v) for v in np.asarray(frame).ravel())))


def _block(layouts, places, contacts, k, parameters):
    """Block between units k and k + 1: both contact panels and what fills the gap between them."""
    below, above = layouts[k].plates[contacts[k][1]], layouts[k + 1].plates[contacts[k + 1][0]]
    to_print = places[k], places[k + 1]
    cores = [
        in_print_plan(plate.core, place)
        for plate, place in zip((below, above), to_print, strict=True)
    ]
    filler = plan.intersection(*cores, inset=BLOCK_INSET)
    if not filler:
        raise ValueError(
            f"Units {k + 1} and {k + 2} have no common contact panel: make EdgeLength larger."
        )
    faces, fingers, taken = [], [], 0.0
    for plate, place, layout in zip((below, above), to_print, layouts[k : k + 2], strict=True):
        if parameters.hinge_type == FLEXIBLE:
            found = strips(layout, parameters)
            fingers += [moved(f, place) for f in fingers_in(found, plate.name)]
            taken += pocket_volume(plate, found)
        hole = in_unit_plan(filler, place)
        outer = 1 if plate.height > 0 else -1
        own = plate_faces(plate, parameters, hole, outer)
        faces += moved(Part.makeCompound(own), place).Faces
    low = (4 * k + 4) * parameters.pitch - parameters.gap_between_planes
    high = low + parameters.gap_between_planes
    for a, b in zip(filler, [*filler[1:], filler[0]], strict=True):
        corners = (a, low), (b, low), (b, high), (a, high)
        faces.append(brep.polygon([brep.Vector(p.real, p.imag, z) for p, z in corners]))
    volume = sum(plate_volume(plate, parameters) for plate in (below, above))
    volume += plan.area(filler) * parameters.gap_between_planes
    name = f"block{k + 1:02d}_{k + 2:02d}"
    shape = with_pockets(brep.solid(faces, volume, name), fingers, volume - taken, name)
    return Body(name, shape, k, ((k, contacts[k][1]), (k + 1, contacts[k + 1][0])))


def in_print_plan(points, place):
    """Plan points (x + i z of the unit) as x + i y of the print frame, counter-clockwise."""
    flat = np.array([[p.real, 0.0, p.imag, 1.0] for p in points]) @ place.T
    moved_points = [complex(x, y) for x, y in flat[:, :2]]
    return moved_points if plan.area(moved_points) > 0 else moved_points[::-1]


def in_unit_plan(points, place):
    """Points x + i y of the print frame as plan points x + i z of the unit."""
    flat = np.array([[p.real, p.imag, 0.0, 1.0] for p in points]) @ np.linalg.inv(place).T
    return [complex(x, z) for x, z in flat[:, [0, 2]]]
