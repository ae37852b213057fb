# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is to be made printable, read from the document once: a search may go on aside."""

from dataclasses import dataclass, replace

import numpy as np
import Part
from FreeCAD import Vector

from ..objects.base import default_of
from ..objects.edges import EdgeChain
from ..objects.hinge_inputs import hinge_parameters
from ..objects.hinge_set import GIVEN, HingeSet
from ..origami.curves.gentler import gentler
from ..origami.curves.spheres import Projected
from ..origami.design import CurveGeometry
from ..origami.errors import Refusal, name_of
from ..origami.fit.options import Wish, finer
from ..origami.fit.printable import printable
from ..origami.hinges.bed import Bed, split
from ..origami.hinges.kinds import ROTATIONAL
from ..origami.hinges.processes import PROCESSES
from ..origami.progress import NOBODY
from ..origami.snap.table import USUAL
from .chain import Chain, course_of

_POINTS = 161  # of a gentler curve


@dataclass(frozen=True)
class Request:
    """A curve, a `Wish`, and whether prints stand on edge. Nothing of it is the document's."""

    geometry: CurveGeometry
    wish: Wish
    on_edge: bool = False

    def search(self, progress=NOBODY) -> tuple:
        """(`origami.fit.printable.Printable` or None, [(option, refusal)]); some seconds."""
        return printable(self.geometry, self.wish, self._parts, progress, self._bent)

    def _parts(self, tube, hinges):
        bed = Bed(*self.wish.bed)
        return split(tube.thick, hinges, bed, tube.tube.incoming_left, self.on_edge)

    def _bent(self, width):
        """A gentler `CurveGeometry`, and its largest change (mm): the curve that the kernel draws.

        So what is measured of it is what a document then has.
        """
        edge, change = gentler_edge(self.geometry, width)
        curve = EdgeChain([edge], "")
        if self.geometry.family == "Sphere":
            curve = _on_sphere(self.geometry, curve)
        return replace(self.geometry, curve=curve), change


def request_of(chain: Chain, bed=None, margin=1.2, hinges=None, least_gap=0.0) -> Request:
    """The `Request` of a `Chain`: with the hinges of its hinge sets, else with those of new ones.

    ``bed`` (x, y, z) mm, None: that of the hinge sets, else a usual one; ``margin``: smallest snap
    margin of all units, as `HingeSet.SnapMargins` measures it; ``hinges``: `HingeParameters` of new
    hinge sets, None: the usual ones; ``least_gap`` (mm) that the printer keeps open.
    """
    own = tuple(chain.hinge_sets[0].Bed) if chain.hinge_sets else ()
    bed = bed or (own if any(own) else Wish.bed)
    bed, margin = tuple(float(x) for x in bed), float(margin)
    for name, value in (("Bed", min(bed)), ("TargetMargin", margin)):
        if not (np.isfinite(value) and value > 0):
            raise Refusal(
                "{name} is {value:.6g}: set it to a number above 0.",
                parameter=name, name=name_of(name), value=value,
            )  # fmt: skip
    wish = Wish(bed, margin)
    hinges = hinges or replace(USUAL, process=default_of(HingeSet, "Process"))
    on_edge = PROCESSES[hinges.process].orientation == "OnEdge"
    if chain.hinge_sets:
        first = chain.hinge_sets[0]
        on_edge = first.Orientation == "OnEdge"
        hinges = replace(hinge_parameters(first), hinge_type=ROTATIONAL)
        if first.PreloadRule == GIVEN:
            wish = replace(wish, preload=first.Preload)
    return Request(course_of(chain), replace(wish, panels=finer(hinges, least_gap)), on_edge)


def gentler_edge(geometry, width):
    """(Part edge, largest change in mm): a gentler curve as the kernel draws it.

    ``geometry``: the drawn curve in the global frame; ``width`` (mm) as of `gentler`.
    """
    curve, change = gentler(geometry.curve, width)
    if geometry.family == "Sphere":
        curve = _on_sphere(geometry, curve)
    points = curve.point(np.linspace(0, 1, _POINTS))
    closed = bool(np.linalg.norm(points[0] - points[-1]) < 1e-6 * np.ptp(points))
    vectors = [Vector(*p) for p in points.tolist()]
    spline = Part.BSplineCurve()
    spline.interpolate(vectors[:-1] if closed else vectors, PeriodicFlag=closed)
    return spline.toShape(), change


def _on_sphere(geometry, curve):
    return Projected(curve, np.asarray(geometry.legs[1], float), geometry.sphere_radius)
