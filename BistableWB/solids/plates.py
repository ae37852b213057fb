# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels with their knuckles: plate, a "J" for each knuckle, cones or pins (``hinges.md`` 2)."""

from math import copysign, sqrt

from ..origami.hinge_parameters import PIN
from ..origami.hinge_plan import Tab
from . import brep


def plate_solid(plate, parameters, volume):
    """Solid of one `Plate` in the unit's flat frame; ``volume`` is the predicted one (mm³)."""
    return brep.solid(plate_faces(plate, parameters), volume, plate.name)


def plate_faces(plate, parameters, hole=None, hole_side=0):
    """All faces of a plate with its knuckles.

    ``hole``: corners of a polygon inside the core that is left out of the lower (``hole_side`` −1)
    or upper (+1) face, where a block goes on.
    """
    half = parameters.face_thickness / 2
    faces = []
    for side in (-1, 1):
        height = plate.height + side * half
        outline = plate.outline(lambda tab, s=side: tip_depth(tab, plate, s, parameters))
        points = [brep.at(p, height) for p in outline]
        if hole is not None and side == hole_side:
            inner = brep.Part.makePolygon([brep.at(p, height) for p in [*hole, hole[0]]])
            faces.append(brep.with_hole(brep.Part.makePolygon([*points, points[0]]), inner))
        else:
            faces.append(brep.polygon(points))
    faces += _edge_faces(plate, half)
    for tab in plate.tabs:
        faces += _knuckle_faces(tab, _side(tab, plate), parameters)
    return faces


def tip_depth(tab, plate, side, parameters):
    """Depth (mm) at which a tab ends on the plate's face at ``side`` (−1 lower, +1 upper).

    The outer face (away from the axis) is tangent to the barrel and ends below the axis; the inner
    one ends where it meets the barrel.
    """
    return inner_depth(parameters) if side == _side(tab, plate) else 0.0


def inner_depth(parameters):
    """Distance from the axis (mm) at which a plate's inner face meets the barrel."""
    return sqrt(parameters.radius**2 - (parameters.gap_between_planes / 2) ** 2)


def _side(tab, plate):
    return copysign(1, tab.hinge.height - plate.height)


def _edge_faces(plate, half):
    """Upright faces round the core, between the tabs."""
    stops = []
    for item in plate.ring:
        if isinstance(item, Tab):
            first, last = (0, 1) if item.forward else (1, 0)
            stops += [(item.corner(first), False), (item.corner(last), True)]
        else:
            stops.append((item, True))
    faces = []
    for (a, open_edge), (b, _) in zip(stops, [*stops[1:], stops[0]], strict=True):
        if open_edge:
            low, high = plate.height - half, plate.height + half
            corners = (a, low), (b, low), (b, high), (a, high)
            faces.append(brep.polygon([brep.at(*corner) for corner in corners]))
    return faces


def _knuckle_faces(tab, side, parameters):
    """Barrel, both ends, and cone, recess, pin or bore of one knuckle."""
    start, end = tab.hinge.segments[tab.index]
    axis = brep.at(tab.hinge.direction, 0.0)
    wires = [_profile(tab, k, side, parameters) for k in (0, 1)]
    faces = [wires[0][0].extrude(axis * (end - start))]
    centres = [brep.at(tab.hinge.point(s), tab.hinge.height) for s in (start, end)]
    radii, more = pivot_features(tab.hinge, parameters, tab.index, centres, axis)
    for edges, centre, radius in zip(wires, centres, radii, strict=True):
        wire = brep.Part.Wire(edges)
        faces.append(
            brep.with_hole(wire, brep.circle(radius, centre, axis))
            if radius
            else brep.Part.Face(wire)
        )
    return faces + more


def _profile(tab, end, side, parameters):
    """Edges of the "J" at one end of a knuckle; the first is the barrel's arc."""
    r, half_gap = parameters.radius, parameters.gap_between_planes / 2
    n, depth = inner_depth(parameters), tab.depths[end]

    def point(into, up):
        return brep.at(tab.corner(end, into), tab.hinge.height + side * up)

    tangent, inner = point(0, -r), point(n, -half_gap)
    far_inner, far_outer = point(depth, -half_gap), point(depth, -r)
    return [
        brep.arc(tangent, point(-r, 0), inner),
        brep.line(inner, far_inner),
        brep.line(far_inner, far_outer),
        brep.line(far_outer, tangent),
    ]


def pivot_features(hinge, parameters, index, centres, axis):
    """What makes knuckle ``index`` of a hinge turn: (hole radii in both its end faces, faces).

    ``centres``: of its end faces; ``axis``: unit vector along the hinge.
    """
    make = _pin_features if parameters.pivot == PIN else _cone_features
    return make(hinge, parameters, index, centres, axis)


def _cone_features(hinge, parameters, index, centres, axis):
    """Recess at the start of a knuckle and cone at its end, except at the ends of the hinge."""
    base, tip = parameters.cone_base, parameters.tip_radius(hinge.cone_height)
    has = index > 0, index < len(hinge.segments) - 1
    faces = []
    for present, centre in zip(has, centres, strict=True):
        if present:
            faces += brep.cone(base, tip, hinge.cone_height, centre, axis)
    return [base if present else 0.0 for present in has], faces


def _pin_features(hinge, parameters, index, centres, axis):
    """Pin from an even knuckle through the next ring, or the bore of an odd knuckle (a ring)."""
    radius = parameters.pin_radius
    start, end = hinge.segments[index]
    if index % 2:
        bore = radius + parameters.gap_length
        return [bore, bore], [brep.tube(bore, centres[0], axis, end - start)]
    last = index == len(hinge.segments) - 1
    faces = []
    if not last:
        faces.append(brep.tube(radius, centres[1], axis, hinge.segments[index + 2][0] - end))
    return [radius if index else 0.0, 0.0 if last else radius], faces
