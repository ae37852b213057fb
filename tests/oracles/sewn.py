# SPDX-License-Identifier: LGPL-2.1-or-later
"""Panels and links as earlier versions made them: faces one by one, sewn by the kernel.

An oracle for boundaries: another construction of the same bodies, with the kernel's own surfaces.
"""

from itertools import pairwise
from math import copysign, sqrt

import Part
from FreeCAD import Vector

from BistableWB.origami.hinges import polygons
from BistableWB.origami.hinges.link_section import link_section
from BistableWB.origami.hinges.parameters import PIN
from BistableWB.origami.hinges.unit_layout import Tab


def at(plan_point, height):
    """Vector of a unit's flat frame from a plan point (x + i z) and a height (mm)."""
    return Vector(plan_point.real, height, plan_point.imag)


def polygon(points):
    """Plane face with the given corners."""
    return Part.Face(Part.makePolygon([*points, points[0]]))


def line(a, b):
    """Straight edge."""
    return Part.LineSegment(a, b).toShape()


def arc(a, middle, b):
    """Circular edge through three points."""
    return Part.Arc(a, middle, b).toShape()


def circle(radius, centre, axis):
    """Circular wire."""
    return Part.Wire(Part.makeCircle(radius, centre, axis))


def with_hole(outer, hole):
    """Plane face between an outer wire and a hole (``Part.Face`` of two wires is unreliable)."""
    return Part.makeFace([outer, hole], "Part::FaceMakerBullseye")


def tube(radius, start, axis, length):
    """Lateral face of a cylinder."""
    return Part.makeCylinder(radius, length, start, axis).Faces[0]


def cone(base, tip, height, start, axis):
    """Lateral face and tip disc of a blunt cone that stands on ``start``."""
    lateral = Part.makeCone(base, tip, height, start, axis).Faces[0]
    return [lateral, Part.Face(circle(tip, start + axis * height, axis))]


def solid(faces):
    """One closed solid sewn from ``faces``."""
    shell = Part.makeShell(faces)
    assert shell.ShapeType == "Shell"
    assert shell.isClosed()
    body = Part.makeSolid(shell)
    if body.Volume < 0:
        body.reverse()
    return body


def plate_solid(plate, parameters):
    """Solid of one `Plate` in the unit's flat frame."""
    return solid(plate_faces(plate, parameters))


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
        points = [at(p, height) for p in outline]
        if hole is not None and side == hole_side:
            inner = Part.makePolygon([at(p, height) for p in [*hole, hole[0]]])
            faces.append(with_hole(Part.makePolygon([*points, points[0]]), inner))
        else:
            faces.append(polygon(points))
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
            faces.append(polygon([at(*corner) for corner in corners]))
    return faces


def _knuckle_faces(tab, side, parameters):
    """Barrel, both ends, and cone, recess, pin or bore of one knuckle."""
    start, end = tab.hinge.segments[tab.index]
    axis = at(tab.hinge.direction, 0.0)
    wires = [_profile(tab, k, side, parameters) for k in (0, 1)]
    faces = [wires[0][0].extrude(axis * (end - start))]
    centres = [at(tab.hinge.point(s), tab.hinge.height) for s in (start, end)]
    radii, more = pivot_features(tab.hinge, parameters, tab.index, centres, axis)
    for edges, centre, radius in zip(wires, centres, radii, strict=True):
        wire = Part.Wire(edges)
        faces.append(with_hole(wire, circle(radius, centre, axis)) if radius else Part.Face(wire))
    return faces + more


def _profile(tab, end, side, parameters):
    """Edges of the "J" at one end of a knuckle; the first is the barrel's arc."""
    r, half_gap = parameters.radius, parameters.gap_between_planes / 2
    n, depth = inner_depth(parameters), tab.depths[end]

    def point(into, up):
        return at(tab.corner(end, into), tab.hinge.height + side * up)

    tangent, inner = point(0, -r), point(n, -half_gap)
    far_inner, far_outer = point(depth, -half_gap), point(depth, -r)
    return [
        arc(tangent, point(-r, 0), inner),
        line(inner, far_inner),
        line(far_inner, far_outer),
        line(far_outer, tangent),
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
            faces += cone(base, tip, hinge.cone_height, centre, axis)
    return [base if present else 0.0 for present in has], faces


def _pin_features(hinge, parameters, index, centres, axis):
    """Pin from an even knuckle through the next ring, or the bore of an odd knuckle (a ring)."""
    radius = parameters.pin_radius
    start, end = hinge.segments[index]
    if index % 2:
        bore = radius + parameters.gap_length
        return [bore, bore], [tube(bore, centres[0], axis, end - start)]
    last = index == len(hinge.segments) - 1
    faces = []
    if not last:
        faces.append(tube(radius, centres[1], axis, hinge.segments[index + 2][0] - end))
    return [radius if index else 0.0, 0.0 if last else radius], faces


def link_solid(link, parameters):
    """Solid of one `Link` in the unit's flat frame."""
    indices = range(1, len(link.hinges[0].segments), 2)
    faces, before, last_holes = [], None, None
    for index in indices:
        start, end = (_Section(link, parameters, index, k) for k in (0, 1))
        holes, features = _features(link, parameters, index)
        if before is None:
            faces.append(start.face(start.dogbone(), holes[0]))
        else:
            faces.append(before.face(before.shoulder(), last_holes))
            faces.append(start.face(start.shoulder(), holes[0]))
            faces += sweep(before.spine(), start.spine())
        faces += sweep(start.dogbone(), end.dogbone()) + features
        before, last_holes = end, holes[1]
    faces.append(before.face(before.dogbone(), last_holes))
    return solid(faces)


def sweep(first, second):
    """Side faces between two sections with the same edges."""
    faces = []
    for a, b in zip(first, second, strict=True):
        move = b.Vertexes[0].Point - a.Vertexes[0].Point
        same = (b.Vertexes[-1].Point - a.Vertexes[-1].Point - move).Length < 1e-9
        faces.append(a.extrude(move) if same else Part.makeRuledSurface(a, b))
    return faces


def _features(link, parameters, index):
    """Holes of both axes at both ends of a dogbone, and the faces of what is in them.

    They point along the mean line, so that they lie in the section where the axes of a general
    unit are not quite parallel.
    """
    holes, faces = ([], []), []
    axis = at(polygons.unit(sum(hinge.direction for hinge in link.hinges)), 0.0)
    for hinge in link.hinges:
        centres = [at(hinge.point(s), hinge.height) for s in hinge.segments[index]]
        radii, more = pivot_features(hinge, parameters, index, centres, axis)
        faces += more
        for k in (0, 1):
            holes[k].append(circle(radii[k], centres[k], axis))
    return holes, faces


class _Section:
    """Edges of a link's section at one end (0, 1) of dogbone ``index``."""

    def __init__(self, link, parameters, index, end):
        self.link, self.size = link, link_section(parameters)
        self.radius = parameters.radius
        self.centres = [hinge.point(hinge.segments[index][end]) for hinge in link.hinges]

    def point(self, which, n, v):
        """Point n outwards and v towards the other axis, from the lower (0) or upper (1) axis."""
        height = self.link.hinges[which].height + (v if which == 0 else -v)
        return at(self.centres[which] + n * self.link.outward, height)

    def dogbone(self):
        """Closed section at a dogbone."""
        return [*self._barrels(), *self._collar(1), *self._back(), *reversed(self._collar(0))]

    def spine(self):
        """Closed section between two dogbones."""
        return [*self._back(), *self._hollow()]

    def shoulder(self):
        """Closed section of a dogbone less the spine."""
        return [*self._barrels(), *self._collar(1), *self._hollow(), *self._collar(0)]

    def face(self, edges, holes):
        """Plane face within ``edges`` with ``holes`` (wires)."""
        wire = Part.Wire(Part.__sortEdges__(edges))
        return Part.makeFace([wire, *holes], "Part::FaceMakerBullseye")

    def _barrels(self):
        r, w = self.radius, self.size.web
        q = sqrt(r * r - w * w)
        p = self.point
        return [
            arc(p(0, r, 0), p(0, 0, -r), p(0, -w, q)),
            line(p(0, -w, q), p(1, -w, q)),
            arc(p(1, -w, q), p(1, 0, -r), p(1, r, 0)),
        ]

    def _collar(self, which):
        return [line(self.point(which, self.radius, 0), self.point(which, self.size.clear, 0))]

    def _back(self):
        p, clear, outer = self.point, self.size.clear, self.size.outer
        corners = [p(1, clear, 0), p(1, outer, 0), p(0, outer, 0), p(0, clear, 0)]
        return [line(a, b) for a, b in pairwise(corners)]

    def _hollow(self):
        p, clear, inner = self.point, self.size.clear, self.size.inner
        high = sqrt(clear * clear - inner * inner)
        return [
            arc(p(0, clear, 0), p(0, *self._on_arc(inner)), p(0, inner, high)),
            line(p(0, inner, high), p(1, inner, high)),
            arc(p(1, inner, high), p(1, *self._on_arc(inner)), p(1, clear, 0)),
        ]

    def _on_arc(self, inner):
        n = (inner + self.size.clear) / 2
        return n, sqrt(self.size.clear**2 - n * n)
