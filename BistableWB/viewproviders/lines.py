# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curve and zigzag in the view: seen through the panels that hide them."""

import FreeCAD as App
from pivy import coin

from .. import colours
from ..origami.curves.families import FAMILIES
from ..scene.overlay import DASHES, SOLID, overlay
from .base import BistableView

_POINTS_PER_CURVE = 65
_CURVE, _ZIGZAG = colours.rgb(colours.CURVE), colours.rgb(colours.INK)
_WHITE = (1.0, 1.0, 1.0)


class LinesView(BistableView):
    """Lines that stay readable: a thin copy is drawn over everything."""

    # layers of the overlay, lowest first: colour, width, pattern
    OVERLAY: tuple = ()

    def attach(self, view_object):
        """Add the copy to what FreeCAD draws."""
        super().attach(view_object)
        self.points, self.lines = coin.SoCoordinate3(), coin.SoLineSet()
        self.switch = overlay(self.OVERLAY, self.points, self.lines)
        view_object.RootNode.addChild(self.switch)
        self.onChanged(view_object, "Visibility")
        self.refresh(view_object.Object)

    def refresh(self, obj):
        """Let the copy follow the shape."""
        shape = obj.Shape.copy()
        if shape.isNull():
            return
        shape.Placement = App.Placement()  # the view's own transform applies the object's
        points, counts = _polylines(shape)
        self.points.point.setNum(len(points))
        self.points.point.setValues(0, len(points), points)
        self.lines.numVertices.setNum(len(counts))
        self.lines.numVertices.setValues(0, len(counts), counts)

    def onChanged(self, view_object, name):
        """Hide the copy together with the object."""
        if name == "Visibility" and hasattr(self, "switch"):
            shown = coin.SO_SWITCH_ALL if view_object.Visibility else coin.SO_SWITCH_NONE
            self.switch.whichChild = shown


class CurveView(LinesView):
    """The curve that the tube follows."""

    LOOK = {
        "LineColor": _CURVE,
        "PointColor": _CURVE,
        "LineWidth": 3.0,
        "PointSize": 7.0,
        "Deviation": 0.1,
        "AngularDeflection": 5.0,
    }
    OVERLAY = ((_WHITE, 5.0, SOLID), (_CURVE, 3.0, SOLID))

    def icon_name(self, obj):
        """That of the family: the one that was chosen, else the one that was found."""
        family = FAMILIES.get(obj.Kind) or FAMILIES.get(obj.FoundKind)
        return family.icon if family else "Curve"


class TrianglePlacementView(LinesView):
    """The zigzag of segments whose midpoints lie on the curve."""

    LOOK = {
        "LineColor": _ZIGZAG,
        "PointColor": _ZIGZAG,
        "LineWidth": 2.0,
        "PointSize": 5.0,
    }
    OVERLAY = ((_ZIGZAG, 2.0, SOLID), (_WHITE, 2.0, DASHES))


def _polylines(shape):
    """Points of all edges one after the other, and how many each edge has."""
    points, counts = [], []
    for edge in shape.Edges:
        straight = edge.Curve.TypeId == "Part::GeomLine"
        part = [v.Point for v in edge.Vertexes] if straight else edge.discretize(_POINTS_PER_CURVE)
        points += [tuple(p) for p in part]
        counts.append(len(part))
    return points, counts
