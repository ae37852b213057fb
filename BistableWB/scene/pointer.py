# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points at places of a print in the 3D view: its bodies selected, rings drawn over everything."""

import contextlib

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from pivy import coin

from .. import colours
from ..objects import type_of
from ..objects.base import global_placement
from ..solids.matrices import array_of
from .shown import bodies_shown

_COLOUR = colours.rgb("#C2185B")


class Pointer:
    """Shows one finding of the checks at a time on the print ``obj``; `clear` when done."""

    def __init__(self, obj):
        self.obj = obj
        self.scene = self.node = self.plane = None

    def show(self, finding):
        """Select the bodies of a `Finding`, bring them into view and mark its points.

        Most findings are inside the stack: what is nearer to the eye than the first point is cut
        away, as the view is turned now.

        The points stand where they are on the print as the view shows it now, whichever state the
        check looked at.
        """
        self.clear()
        Gui.Selection.clearSelection()
        elements = elements_of(self.obj, finding.bodies)
        if elements:
            Gui.Selection.addSelection(self.obj, elements)
        view = Gui.getDocument(self.obj.Document).ActiveView
        if not hasattr(view, "getSceneGraph"):
            return
        points = self._now(finding)
        if points:
            self.scene, self.node = view.getSceneGraph(), _rings(points)
            self.scene.addChild(self.node)
            self._cut(points[0], view.getViewDirection())
        if elements:
            Gui.SendMsgToActiveView("ViewSelection")

    def clear(self):
        """Take the marks away, and show again what was cut away."""
        with contextlib.suppress(ReferenceError):  # deleted in the meantime
            if self.plane is not None and self.obj.ViewObject is not None:
                self.obj.ViewObject.RootNode.removeChild(self.plane)
        self.plane = None
        if self.node is not None:
            self.scene.removeChild(self.node)
        self.scene = self.node = None

    def _cut(self, point, along):
        """Show only what lies behind ``point`` for an eye that looks ``along``."""
        self.plane = coin.SoClipPlane()
        self.plane.plane = coin.SbPlane(coin.SbVec3f(*along), coin.SbVec3f(*point))
        self.obj.ViewObject.RootNode.insertChild(self.plane, 0)

    def _now(self, finding):
        """The finding's points in global coordinates, carried along with its first body."""
        points = np.array(finding.points, float).reshape(-1, 3)
        if type_of(self.obj) == "Bistable::HingeSet":
            model = self.obj.Proxy.model(self.obj)
            names = [body.name for body in model.bodies]
            known = [name for name in finding.bodies if name in names]
            if not known:
                return []
            index = names.index(known[0])
            lying = array_of(model.standing(self.obj.Orientation))

            def pose(opening, flat):
                found = flat if not opening else model.motions(opening)[index]
                return flat if found is None else found

            then = lying if finding.opening is None else pose(finding.opening, np.eye(4))
            move = pose(self.obj.Deployment, lying) @ np.linalg.inv(then)
            points = points @ move[:3, :3].T + move[:3, 3]
        place = global_placement(self.obj)
        return [tuple(place.multVec(App.Vector(*point))) for point in points.tolist()]


def elements_of(obj, places):
    """Elements of a print's bodies by their names; a unit ("unit03") stands for its bodies."""
    return [
        body.element
        for body in bodies_shown(obj)
        if {body.name, *(f"unit{unit:02d}" for unit in body.units)} & set(places)
    ]


def _rings(points):
    """Node that draws a ring and a dot at each point, over all that would hide them."""
    node = coin.SoAnnotation()
    light, colour = coin.SoLightModel(), coin.SoBaseColor()
    light.model, colour.rgb = coin.SoLightModel.BASE_COLOR, _COLOUR
    pick, where = coin.SoPickStyle(), coin.SoCoordinate3()
    pick.style = coin.SoPickStyle.UNPICKABLE
    where.point.setValues(0, len(points), points)
    for part in (pick, light, colour, where):
        node.addChild(part)
    for index in (coin.SoMarkerSet.CIRCLE_LINE_9_9, coin.SoMarkerSet.CIRCLE_FILLED_5_5):
        mark = coin.SoMarkerSet()
        mark.markerIndex = index
        node.addChild(mark)
    return node
