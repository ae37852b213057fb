# SPDX-License-Identifier: LGPL-2.1-or-later
"""TrianglePlacement: isosceles triangles along a curve (section 3.1 of the paper)."""

import math

import FreeCAD as App
import numpy as np
import Part

from ..origami.placement import place
from . import curve as curves
from .base import BistableObject, Prop, Result, global_placement, require_link, set_result


class TrianglePlacement(BistableObject):
    """Zigzag of segments of length ‖AB‖ with their midpoints on the curve."""

    Type = "Bistable::TrianglePlacement"
    PROPERTIES = (
        Prop("Link", "Curve", "Placement", "Curve that the tube follows"),
        Prop("Length", "EdgeLength", "Placement", "Length ‖AB‖ of the units' long edge: the width "
             "of the tube", 40.0),
        Prop("Angle", "Gamma", "Placement", "Angle by which the first segment leans forward; "
             "larger opens all units wider", 20.0),
        Prop("Length", "Thickness", "Placement", "Pitch of the thick panels (face thickness + gap "
             "between planes) to allow for; 0 is the paper's zero-thickness rule", 0.0),
        Prop("Bool", "FlipSide", "Placement", "Start with the unit on the other side of the "
             "curve", False),
        Prop("Bool", "Level", "Placement", "For curves of kind General with a direction as Ruling: "
             "keep the segments from tilting along the way (long helices)", False),
        Result("Integer", "Count", "Results", "Number of units"),
        Result("FloatList", "Thetas", "Results", "Opening angle of every unit, degrees"),
        Result("Angle", "ThetaMin", "Results", "Smallest opening angle"),
        Result("Angle", "ThetaMax", "Results", "Largest opening angle"),
        Result("Float", "Coverage", "Results", "Length of curve that the tube follows / length "
               "of the curve"),
    )  # fmt: skip

    def generate(self, obj):
        """Place the triangles, draw the zigzag, publish the angles."""
        placed, _ = place_along(obj)
        degrees = np.degrees(placed.thetas)
        set_result(
            obj,
            Count=len(placed),
            Thetas=degrees.tolist(),
            ThetaMin=_angle(degrees.min()),
            ThetaMax=_angle(degrees.max()),
            Coverage=placed.followed / placed.length,
        )
        back = global_placement(obj).inverse()
        corners = [back.multVec(App.Vector(*p)) for p in placed.points.tolist()]
        if placed.pitch:
            pairs = [[back.multVec(App.Vector(*p)) for p in s] for s in placed.segments.tolist()]
            obj.Shape = Part.makeCompound([Part.makeLine(*pair) for pair in pairs])
        else:
            obj.Shape = Part.makePolygon(corners)


def place_along(obj, extra=()):
    """`Placement` of a TrianglePlacement object and the `CurveGeometry` it stands on.

    ``extra`` is for thick panels: see `origami.placement.place`.
    """
    geometry = geometry_below(obj)
    return place_on(obj, geometry, extra), geometry


def geometry_below(obj):
    """`CurveGeometry` of the Curve that a TrianglePlacement object stands on."""
    linked = require_link(obj, "Curve", curves.Curve.Type, "choose a Curve of this workbench")
    return curves.geometry_of(linked)


def place_on(obj, geometry, extra=()):
    """`Placement` by the parameters of a TrianglePlacement object along a `CurveGeometry`."""
    return place(
        geometry.curve,
        obj.EdgeLength.Value,
        math.radians(obj.Gamma.Value),
        obj.Thickness.Value,
        geometry.legs,
        obj.FlipSide,
        extra,
        obj.Level,
    )


def _angle(degrees):
    return App.Units.Quantity(float(degrees), App.Units.Angle)
