# SPDX-License-Identifier: LGPL-2.1-or-later
"""Links of the double hinges ("offset crease" in the paper): dogbones joined by a spine.

Section (n outwards, away from the panels; v along the stack): a barrel on each axis, a web between
them, and outside the reach of the panels' knuckles a spine that makes all dogbones one body.
"""

from itertools import pairwise
from math import sqrt

from ..origami import plan
from ..origami.hinge_plan import link_section
from . import brep
from .plates import pivot_features


def link_solid(link, parameters, volume):
    """Solid of one `Link` in the unit's flat frame; ``volume`` is the predicted one (mm³)."""
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
    return brep.solid(faces, volume, link.name)


def sweep(first, second):
    """Side faces between two sections with the same edges."""
    faces = []
    for a, b in zip(first, second, strict=True):
        move = b.Vertexes[0].Point - a.Vertexes[0].Point
        same = (b.Vertexes[-1].Point - a.Vertexes[-1].Point - move).Length < 1e-9
        faces.append(a.extrude(move) if same else brep.Part.makeRuledSurface(a, b))
    return faces


def _features(link, parameters, index):
    """Holes of both axes at both ends of a dogbone, and the faces of what is in them.

    They point along the mean line, so that they lie in the section where the axes of a general
    unit are not quite parallel.
    """
    holes, faces = ([], []), []
    axis = brep.at(plan.unit(sum(hinge.direction for hinge in link.hinges)), 0.0)
    for hinge in link.hinges:
        centres = [brep.at(hinge.point(s), hinge.height) for s in hinge.segments[index]]
        radii, more = pivot_features(hinge, parameters, index, centres, axis)
        faces += more
        for k in (0, 1):
            holes[k].append(brep.circle(radii[k], centres[k], axis))
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
        return brep.at(self.centres[which] + n * self.link.outward, height)

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
        wire = brep.Part.Wire(brep.Part.__sortEdges__(edges))
        return brep.Part.makeFace([wire, *holes], "Part::FaceMakerBullseye")

    def _barrels(self):
        r, w = self.radius, self.size.web
        q = sqrt(r * r - w * w)
        p = self.point
        return [
            brep.arc(p(0, r, 0), p(0, 0, -r), p(0, -w, q)),
            brep.line(p(0, -w, q), p(1, -w, q)),
            brep.arc(p(1, -w, q), p(1, 0, -r), p(1, r, 0)),
        ]

    def _collar(self, which):
        return [brep.line(self.point(which, self.radius, 0), self.point(which, self.size.clear, 0))]

    def _back(self):
        p, clear, outer = self.point, self.size.clear, self.size.outer
        corners = [p(1, clear, 0), p(1, outer, 0), p(0, outer, 0), p(0, clear, 0)]
        return [brep.line(a, b) for a, b in pairwise(corners)]

    def _hollow(self):
        p, clear, inner = self.point, self.size.clear, self.size.inner
        high = sqrt(clear * clear - inner * inner)
        return [
            brep.arc(p(0, clear, 0), p(0, *self._on_arc(inner)), p(0, inner, high)),
            brep.line(p(0, inner, high), p(1, inner, high)),
            brep.arc(p(1, inner, high), p(1, *self._on_arc(inner)), p(1, clear, 0)),
        ]

    def _on_arc(self, inner):
        n = (inner + self.size.clear) / 2
        return n, sqrt(self.size.clear**2 - n * n)
