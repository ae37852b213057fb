# SPDX-License-Identifier: LGPL-2.1-or-later
"""HingeSet and HingeCoupon in the view: solids, coloured by what each body is."""

import FreeCAD as App
import Part
from pivy import coin
from PySide import QtCore

from .. import colours
from . import faces, settings
from .body_nodes import BodyNodes, meshed
from .coloured import ColouredView

LINK = colours.MUTED
STRIP = colours.CURVE
_PLATES = ("border", "primary", "contact", "secondary")  # for a coupon's plates, one by one
_PATTERNS = {"Solid": 0xFFFF, "Dashed": 0xF00F, "Dotted": 0x0F0F, "Dashdot": 0xFF88}


def body_colour(name, number=0):
    """RGB of a body by its name: its panel's kind, blocks as the contact panels that they are.

    ``number`` tells bodies apart that have no kind.
    """
    if "strip" in name:
        return colours.rgb(STRIP)
    if "block" in name:
        return settings.panel_colour("contact")
    if "link" in name:
        return colours.rgb(LINK)
    kinds = [kind for kind in colours.PANELS if kind in name]
    # longest first: "secondary" must not be taken for anything shorter
    return settings.panel_colour(max(kinds, key=len) if kinds else _PLATES[number % 4])


def bodies_shown(obj):
    """(name, element) of the bodies in an object's shape; elements are what can be selected.

    Flexible strips are there only when flat. Empty where names and shape do not belong together
    (while a file is being opened).
    """
    count = obj.Shape.countElement("Solid")
    names = list(obj.BodyNames)
    if len(names) != count:
        names = [name for name in names if "strip" not in name]
    return [(name, f"Solid{k + 1}") for k, name in enumerate(names)] if len(names) == count else []


class BodiesView(ColouredView):
    """Printed parts: nodes of our own, in which a click takes a body.

    Colours, transparency, lines, points and display modes are FreeCAD's own properties.
    """

    LOOK = {
        "LineColor": colours.rgb(colours.INK),
        "PointColor": colours.rgb(colours.INK),
        "LineWidth": 1.0,
        "PointSize": 2.0,
    }

    def attach(self, view_object):
        """Make the nodes; FreeCAD gets them when it has its own."""
        super().attach(view_object)
        self.nodes, self._is_shown, self._is_due = BodyNodes(), False, False

    # what FreeCAD asks and tells

    def updateData(self, obj, name):
        """Draw in place of FreeCAD, which does so only for what is seen."""
        if name == "Shape" and hasattr(self, "nodes"):
            self._take_over()
            self._is_due = True
            if self._is_seen():
                self._withhold(obj)
        super().updateData(obj, name)

    def onChanged(self, view_object, name):
        """Follow visibility and looks."""
        if not hasattr(self, "nodes"):
            return
        if name == "Visibility" and view_object.Visibility and self._is_due:
            self._withhold(view_object.Object)
            self._draw(view_object.Object)
        elif name in ("DiffuseColor", "ShapeAppearance", "Transparency"):
            self._colour()
        elif name.startswith(("Line", "Point", "DrawStyle")):
            self._style()

    def getElementPicked(self, picked):
        """Name of the body under the mouse."""
        return picked.getPath().getNodeFromTail(1).getName().getString()

    def getDetail(self, element):
        """Part of the nodes that shows an element: its whole body."""
        number = self._body_of(element)
        if number is None:
            return None
        detail = coin.SoFaceDetail()
        detail.setPartIndex(number)
        return detail

    # drawing

    def count(self, obj):
        """Bodies, each of which has one colour."""
        return obj.Shape.countElement("Solid")

    def wanted_colours(self, obj):
        """Every body in the colour of its kind."""
        return [body_colour(name, k) for k, (name, _) in enumerate(bodies_shown(obj))]

    def refresh(self, obj):
        """Draw the shape, in new colours where it has another number of bodies."""
        super().refresh(obj)
        if self._is_seen():
            self._draw(obj)

    def _draw(self, obj):
        self._is_due = False
        shape = Part.Shape(obj.Shape)
        shape.Placement = App.Placement()  # the view's own transform applies the object's
        self.nodes.show([meshed(solid) for solid in shape.Solids])
        self._colour()

    def _colour(self):
        shown = faces.face_colours(self.ViewObject)
        if len(shown) not in (1, len(self.nodes.materials)):
            shown = shown[:1]
        self.nodes.colour(shown, self.ViewObject.Transparency / 100)

    def _style(self):
        look, nodes = self.ViewObject, self.nodes
        nodes.line_colour.rgb = look.LineColor[:3]
        nodes.point_colour.rgb = look.PointColor[:3]
        nodes.line_style.lineWidth = look.LineWidth
        nodes.line_style.linePattern = _PATTERNS.get(look.DrawStyle, _PATTERNS["Solid"])
        nodes.point_style.pointSize = look.PointSize

    def _take_over(self):
        """Show our nodes in FreeCAD's display modes."""
        if self._is_shown:
            return
        self._is_shown, both, faces_only = True, coin.SoSeparator(), coin.SoPickStyle()
        faces_only.style = coin.SoPickStyle.UNPICKABLE
        for node in (self.nodes.faces, faces_only, self.nodes.lines):
            both.addChild(node)
        modes = both, self.nodes.faces, self.nodes.lines, self.nodes.points
        names = "Flat Lines", "Shaded", "Wireframe", "Point"  # by FreeCAD's names for its nodes
        for name, node in zip(names, modes, strict=True):
            self.ViewObject.addDisplayMode(node, name)
        self.ViewObject.DisplayMode = self.ViewObject.DisplayMode  # now by the new nodes
        self._style()

    def _withhold(self, obj):
        """FreeCAD asks for the shape next; should it not, the next one to ask shall get it."""
        proxy = obj.Proxy
        if hasattr(proxy, "withhold_shape"):
            proxy.withhold_shape()
            QtCore.QTimer.singleShot(0, lambda: proxy.withhold_shape(False))

    def _is_seen(self):
        """Whether FreeCAD would draw: the object, or a link to it, is visible."""
        obj = self.ViewObject.Object
        return self.ViewObject.Visibility or any(o.isDerivedFrom("App::Link") for o in obj.InList)

    def _body_of(self, element):
        """Number of the body that an element "Solid3" or "Face123" belongs to."""
        kind, number = element.rstrip("0123456789"), element.lstrip("SolidFace")
        if kind not in ("Solid", "Face") or not number.isdigit():
            return None
        number = int(number) - 1
        if kind == "Face":
            for k, solid in enumerate(self.ViewObject.Object.Shape.Solids):
                number -= solid.countElement("Face")
                if number < 0:
                    return k
        return number if number < len(self.nodes.materials) else None


class HingeSetView(BodiesView):
    """A whole print: without edges, whose drawing would cost more than all the rest."""

    LOOK = BodiesView.LOOK | {"DisplayMode": "Shaded"}
