# SPDX-License-Identifier: LGPL-2.1-or-later
"""A gentler curve beside the drawn one, in a document."""

import FreeCAD as App

from .. import colours
from ..objects.base import global_placement
from ..objects.curve import geometry_of
from .request import gentler_edge

_DRAWN = "#8A97A3"  # grey: what is not followed any more


def follow_gentler(curve, width):
    """Let a Curve object follow a gentler curve than the drawn one, made so over a ``width`` (mm).

    The gentler curve is an object of its own, and so is the drawn one where it was control points;
    both are shown. Of equal curves the same comes out. Returns the largest change, mm.
    """
    doc, geometry = curve.Document, geometry_of(curve)
    edge, change = gentler_edge(geometry, width)
    if curve.Source is None:
        if curve.Shape.isNull():
            doc.recompute([curve])
        drawn = doc.addObject("Part::Feature", "DrawnCurve")
        drawn.Label = f"{curve.Label} (as drawn)"
        drawn.Shape = curve.Shape.copy()
        drawn.Placement = curve.Placement
        _look(drawn, _DRAWN, "Dashed")
    gentler = doc.addObject("Part::Feature", "GentlerCurve")
    gentler.Label = f"{curve.Label} (gentler)"
    gentler.Shape = edge
    _look(gentler, colours.CURVE, "Solid")
    if geometry.family == "Sphere":  # the same one, whatever is found of the new curve
        curve.Kind = "Sphere"
        curve.SphereRadius = float(geometry.sphere_radius)
        centre = App.Vector(*geometry.legs[1])
        curve.SphereCenter = global_placement(curve).inverse().multVec(centre)
    curve.Source = (gentler, [""])
    return change


def _look(obj, colour, style):
    if App.GuiUp:
        obj.ViewObject.LineColor = colours.rgb(colour)
        obj.ViewObject.DrawStyle = style
        obj.ViewObject.LineWidth = 2.0
