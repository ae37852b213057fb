# SPDX-License-Identifier: LGPL-2.1-or-later
"""TrianglePlacement: isosceles triangles along a curve (section 3.1 of the paper)."""

import math

import FreeCAD as App
import numpy as np
import Part

from ..origami.curves.rules import DIRECTIONS, RULES, TOLERANCE, PlacementRule
from ..origami.design import Placing
from ..origami.errors import phrase
from . import curve as curves
from .base import (
    BistableObject,
    Prop,
    Result,
    global_placement,
    require_link,
    set_result,
    set_warnings,
)

CHOICES = ("EndFit", "Steered", "Paper")  # the first is for new objects
assert set(CHOICES) == set(RULES)


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
        Prop("Enumeration", "PlacementRule", "Ends", "EndFit: Gamma is taken near the wanted one, "
             "so that the tube ends at the curve's end. Steered: the tube may leave the curve by "
             "Tolerance, meets both ends and opens evenly. Paper: by Gamma alone, as far as it "
             "goes. Closed curves are closed by EndFit and Steered", list(CHOICES)),
        Prop("Length", "Tolerance", "Ends", "How far a steered tube may leave its curve; 1 % of "
             "EdgeLength until you set it", 0.4),
        Prop("Bool", "Symmetric", "Ends", "Steered along a symmetric curve: the tube is the same "
             "from both ends", False),
        Prop("Enumeration", "StartDirection", "Ends", "Steered: whether the first block stands "
             "square on the curve", list(DIRECTIONS)),
        Prop("Enumeration", "EndDirection", "Ends", "Steered: whether the last block stands square "
             "on the curve", list(DIRECTIONS)),
        Result("Integer", "Count", "Results", "Number of units"),
        Result("FloatList", "Thetas", "Results", "Opening angle of every unit, degrees"),
        Result("Angle", "ThetaMin", "Results", "Smallest opening angle"),
        Result("Angle", "ThetaMax", "Results", "Largest opening angle"),
        Result("Float", "Coverage", "Results", "Length of curve that the tube follows / length "
               "of the curve"),
        Result("Angle", "TakenGamma", "Results", "Gamma of the first segment as it was taken"),
        Result("Length", "EndGap", "Results", "Distance of the last midpoint from the curve's end"),
        Result("Length", "MidpointDeviation", "Results", "Largest distance of a midpoint from the "
               "curve"),
        Result("StringList", "Warnings", "Results", "What was wished and cannot be along this "
               "curve"),
    )  # fmt: skip

    def onBeforeChange(self, obj, name):
        """Remember whether the tolerance goes with the edge length."""
        super().onBeforeChange(obj, name)
        if name == "EdgeLength" and "Tolerance" in obj.PropertiesList:
            self._usual = "Tolerance" in self.following(obj)

    def onChanged(self, obj, name):
        """Keep a tolerance that nobody has set at its share of the edge length."""
        super().onChanged(obj, name)
        if name == "EdgeLength" and self.ready(obj) and getattr(self, "_usual", False):
            obj.Tolerance = TOLERANCE * obj.EdgeLength.Value

    def following(self, obj):
        """The tolerance, until somebody sets it to another share of the edge length."""
        usual = TOLERANCE * obj.EdgeLength.Value
        follows = abs(obj.Tolerance.Value - usual) < 1e-9 * max(usual, 1.0)
        return {"Tolerance"} if follows else set()

    def onDocumentRestored(self, obj):
        """Migrate: tubes of files from before the rules stay as they were."""
        older = "PlacementRule" not in obj.PropertiesList
        super().onDocumentRestored(obj)
        if older:
            obj.PlacementRule = "Paper"

    def generate(self, obj):
        """Place the triangles, draw the zigzag, publish the angles."""
        placed = placing_of(obj).placement()
        degrees = np.degrees(placed.thetas)
        set_result(
            obj,
            Count=len(placed),
            Thetas=degrees.tolist(),
            ThetaMin=_angle(degrees.min()),
            ThetaMax=_angle(degrees.max()),
            Coverage=placed.followed / placed.length,
            TakenGamma=_angle(np.degrees(placed.gamma)),
            EndGap=_length(placed.end_gap),
            MidpointDeviation=_length(placed.off.max()),
        )
        set_warnings(obj, _remarks(placed))
        back = global_placement(obj).inverse()
        corners = [back.multVec(App.Vector(*p)) for p in placed.points.tolist()]
        if placed.pitch:
            pairs = [[back.multVec(App.Vector(*p)) for p in s] for s in placed.segments.tolist()]
            obj.Shape = Part.makeCompound([Part.makeLine(*pair) for pair in pairs])
        else:
            obj.Shape = Part.makePolygon(corners)


def _remarks(placed):
    """What was wished of a placement and the curve does not give."""
    if not placed.unlike:
        return []
    return [
        phrase(
            "{Symmetric}: the curve is neither its own mirror image nor turned half round itself, "
            "it is off by {value:.3g} mm; the tube is steered without.",
            value=placed.unlike,
        )
    ]


def place_along(obj):
    """`Placement` of a TrianglePlacement object and the `CurveGeometry` it stands on."""
    placing = placing_of(obj)
    return placing.placement(), placing.geometry


def geometry_below(obj):
    """`CurveGeometry` of the Curve that a TrianglePlacement object stands on."""
    require_link(obj, "Curve", curves.Curve.Type, phrase("choose a Curve of this workbench"))
    return curves.geometry_of(obj.Curve)


def placing_of(obj):
    """`design.Placing` of a TrianglePlacement object, in the global frame."""
    geometry = geometry_below(obj)
    placing = Placing(
        geometry,
        obj.EdgeLength.Value,
        math.radians(obj.Gamma.Value),
        obj.Thickness.Value,
        obj.FlipSide,
        obj.Level and geometry.legs[0] == "parallel",  # a viewpoint knows no level
        _rule(obj),
    )
    return obj.Proxy.held(placing)


def _rule(obj):
    if obj.PlacementRule != "Steered":
        return PlacementRule(obj.PlacementRule)
    return PlacementRule(
        obj.PlacementRule,
        obj.Tolerance.Value,
        obj.Symmetric,
        obj.StartDirection,
        obj.EndDirection,
    )


def _length(mm):
    return App.Units.Quantity(float(mm), App.Units.Length)


def _angle(degrees):
    return App.Units.Quantity(float(degrees), App.Units.Angle)
