# SPDX-License-Identifier: LGPL-2.1-or-later
"""HingeSet and HingeCoupon in the view: solids, coloured by what each body is."""

import contextlib
import time

import FreeCAD as App
import Part
from pivy import coin
from PySide import QtCore

from .. import colours, settings
from ..objects import later
from ..scene import aside, faces
from ..scene.body_nodes import BodyNodes, meshed
from ..scene.shown import bodies_shown
from .coloured import ColouredView

_SLICE = 0.05  # s of drawing at once
_STALE = colours.rgb("#B4B8BC")  # of bodies that no longer fit their inputs
_PATTERNS = {"Solid": 0xFFFF, "Dashed": 0xF00F, "Dotted": 0x0F0F, "Dashdot": 0xFF88}


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
        self._drawing = None

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

    def is_drawing(self):
        """Whether what is shown is not yet the Shape: it is drawn when the window has time."""
        return self._drawing is not None

    def is_stale(self, obj):
        """Whether the bodies are those of older inputs: they are shown grey."""
        return False

    def wanted_colours(self, obj):
        """Every body in the colour of its kind."""
        return [settings.colour(body.kind) for body in bodies_shown(obj)]

    def refresh(self, obj):
        """Draw the shape, in new colours where it has another number of bodies."""
        super().refresh(obj)
        if self._is_seen():
            self._draw(obj)

    def _draw(self, obj):
        """Draw, in slices where nobody waits; what was shown stays until the last of them."""
        self._is_due = False
        shape = Part.Shape(obj.Shape)
        shape.Placement = App.Placement()  # the view's own transform applies the object's
        self._drawing = self.nodes.showing(meshed(solid) for solid in shape.Solids)
        self._draw_on(self._drawing, 0 if later.nobody_waits() else None)

    def _draw_on(self, drawing, seconds):
        """Draw for some time, then let the window work, and go on; None: to the end."""
        end = None if seconds is None else time.monotonic() + seconds
        while self._drawing is drawing and (end is None or time.monotonic() < end):
            try:
                next(drawing)
            except StopIteration:
                self._drawing = None
                self._colour()
        if self._drawing is drawing:
            QtCore.QTimer.singleShot(0, lambda: self._draw_on_soon(drawing))

    def _draw_on_soon(self, drawing):
        with contextlib.suppress(ReferenceError):  # deleted in the meantime
            self._draw_on(drawing, _SLICE)

    def _colour(self):
        shown = faces.face_colours(self.ViewObject)
        if self.is_stale(self.ViewObject.Object):
            shown = [_STALE]
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

    def attach(self, view_object):
        """From now on there is a window in which solids can be made aside."""
        super().attach(view_object)
        aside.install()

    def updateData(self, obj, name):
        """Follow whether the solids are those of the inputs."""
        super().updateData(obj, name)
        if name == "UpToDate" and getattr(self, "_is_shown", False):
            self._colour()

    def is_stale(self, obj):
        """See `BodiesView.is_stale`."""
        return not getattr(obj, "UpToDate", True)

    def setupContextMenu(self, view_object, menu):
        """Offer to make what is not up to date."""
        super().setupContextMenu(view_object, menu)
        if self.is_stale(view_object.Object):
            text = App.Qt.translate("BistableLive", "Make solids")
            menu.addAction(text).triggered.connect(lambda: aside.make(view_object.Object))
