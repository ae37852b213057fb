# SPDX-License-Identifier: LGPL-2.1-or-later
"""Control points of a Curve in the 3D view: drawn over everything, dragged, clicked, removed."""

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from pivy import coin
from PySide import QtCore, QtGui

from .. import colours
from ..origami.curves.families import wraps
from .camera import Camera

_LEFT, _RIGHT = QtCore.Qt.LeftButton, QtCore.Qt.RightButton
_REACH = 12  # pixels within which a click takes a point
_STEEP = 0.12  # sine of the angle to a plane below which the mouse no longer tells where


class Handles:
    """Points that the mouse moves. ``changed(points)`` gets the new list in the object's frame.

    ``adding``: whether a click beside all points adds one at the end. Where the object follows
    other geometry, its points do not count: they are neither drawn nor dragged.
    """

    def __init__(self, view, obj, changed):
        self.view, self.obj, self.changed = view, obj, changed
        self.adding, self.dragged, self._held = False, None, None
        self.points = [App.Vector(p) for p in obj.Points]
        self._draw()
        self.canvas = canvas_of_active_view()
        self._filter = _MouseFilter(self)
        self.canvas.installEventFilter(self._filter)
        self.show()

    def remove(self):
        """Take everything out of the view again."""
        self.canvas.removeEventFilter(self._filter)
        self.view.getSceneGraph().removeChild(self.root)

    def set_points(self, points):
        """Show other points (from the panel's table)."""
        self.points = [App.Vector(p) for p in points]
        self.show()

    def show(self):
        """Draw the points where they are now."""
        where = [tuple(self._in_space(p)) for p in self.points if self._count()]
        self.coordinates.point.setNum(len(where))
        if where:
            self.coordinates.point.setValues(0, len(where), where)
        self.line.numVertices.setValue(len(where))
        self.switch.whichChild = coin.SO_SWITCH_ALL if where else coin.SO_SWITCH_NONE

    def _draw(self):
        self.root, self.switch = coin.SoAnnotation(), coin.SoSwitch()
        self.coordinates, self.line = coin.SoCoordinate3(), coin.SoLineSet()
        light, pick = coin.SoLightModel(), coin.SoPickStyle()
        light.model, pick.style = coin.SoLightModel.BASE_COLOR, coin.SoPickStyle.UNPICKABLE
        self.root.addChild(self.switch)
        for node in (pick, light, self.coordinates):
            self.switch.addChild(node)
        for colour, size, node in (
            (colours.MUTED, 1.5, self.line),
            ("#FFFFFF", 14.0, coin.SoPointSet()),
            (colours.CURVE, 10.0, coin.SoPointSet()),
        ):
            base, style = coin.SoBaseColor(), coin.SoDrawStyle()
            base.rgb = colours.rgb(colour)
            style.lineWidth = style.pointSize = size
            style.linePattern = 0xF0F0
            for part in (base, style, node):
                self.switch.addChild(part)
        self.view.getSceneGraph().addChild(self.root)

    # mouse: positions are shares of width and height, from the lower left corner

    def press(self, where, button):
        """A button went down; True where that was meant for a point."""
        if not self._count():
            return False
        hit = self._hit(where)
        if button == _LEFT and (hit is not None or (self.adding and self._add(where))):
            self.dragged = len(self.points) - 1 if hit is None else hit
        elif button == _RIGHT and hit is not None:
            del self.points[hit]
            self._tell()
        else:
            return False
        self._held = button
        return True

    def release(self, button):
        """A button went up; True for the one that went down on a point."""
        ours = self._held == button
        if ours:
            self._held, self.dragged = None, None
        return ours

    def move(self, where, buttons=_LEFT):
        """The mouse moves with ``buttons`` held; True while it drags a point.

        FreeCAD swallows a release while it computes: a point whose button is up is let go here.
        """
        if self._held is not None and not buttons & self._held:
            self.release(self._held)
        if self.dragged is None:
            return False
        place = self._under_mouse(where, self.points[self.dragged])
        if place is not None:
            self.points[self.dragged] = place
            self._tell()
        return True

    def _count(self):
        return self.obj.Source is None

    def _add(self, where):
        near = self.points[-1] if self.points else App.Vector()
        place = self._under_mouse(where, near)
        if place is None:
            return False
        self.points.append(place)
        self._tell()
        return True

    def _tell(self):
        self.show()
        self.changed(list(self.points))

    # where things are

    def _camera(self):
        return Camera(self.view, self.canvas.width() / self.canvas.height())

    def _hit(self, where):
        """Number of the point under the mouse, None beside all."""
        camera = self._camera()
        size = np.array([self.canvas.width(), self.canvas.height()])
        best, found = _REACH, None
        for k, point in enumerate(self.points):
            on_screen = np.array(camera.project(self._in_space(point)))
            away = np.linalg.norm((on_screen - where) * size)
            if away < best:
                best, found = away, k
        return found

    def _under_mouse(self, where, near):
        """Place of the control point that belongs under the mouse; None where there is none."""
        back = self._placement().inverse()
        start, along = self._camera().ray(where)
        start, along = back.multVec(start), back.Rotation.multVec(along)
        if wraps(self.obj.Kind):
            return self._on_sphere(start, along)
        general = "General" in (self.obj.Kind, self.obj.FoundKind)
        normal = along if general else plane_normal(self.points)
        slope = along.dot(normal)
        if abs(slope) < _STEEP:
            return None
        return start + along * ((near - start).dot(normal) / slope)

    def _on_sphere(self, start, along):
        """Plan point of the front of the sphere (`curve.Wrapped`, the other way round)."""
        radius, offset = self.obj.SphereRadius.Value, start - self.obj.SphereCenter
        half = offset.dot(along)
        inside = half**2 - offset.dot(offset) + radius**2
        if inside < 0:
            return None
        out = (offset + along * (-half - inside**0.5)) / radius
        flat = np.hypot(out.x, out.y)
        arc = radius * np.arctan2(flat, out.z)
        share = arc / flat if flat > 1e-9 else 0.0
        return App.Vector(out.x * share, out.y * share, 0)

    def _in_space(self, point):
        """Where a control point is drawn."""
        if wraps(self.obj.Kind):
            radius = self.obj.SphereRadius.Value
            flat = np.hypot(point.x, point.y)
            arc = flat / radius
            share = np.sin(arc) / flat if flat > 1e-9 else 0.0
            out = App.Vector(point.x * share, point.y * share, float(np.cos(arc)))
            point = self.obj.SphereCenter + out * radius
        return self._placement().multVec(point)

    def _placement(self):
        return self.obj.getGlobalPlacement()


class _MouseFilter(QtCore.QObject):
    """Gets the mouse before FreeCAD's navigation, whatever style that has."""

    def __init__(self, handles):
        super().__init__()
        self.handles = handles

    def eventFilter(self, canvas, event):
        """True: the event was for the points, nobody else gets it."""
        kind = event.type()
        if kind in (QtCore.QEvent.MouseButtonPress, QtCore.QEvent.MouseButtonDblClick):
            return self.handles.press(_share(canvas, event), event.button())
        if kind == QtCore.QEvent.MouseMove:
            return self.handles.move(_share(canvas, event), event.buttons())
        if kind == QtCore.QEvent.MouseButtonRelease:
            return self.handles.release(event.button())
        return False


def _share(canvas, event):
    where = event.position() if hasattr(event, "position") else event.pos()  # Qt 6, Qt 5
    return where.x() / canvas.width(), 1 - where.y() / canvas.height()


def canvas_of_active_view():
    """The widget in which the active 3D view is drawn and which gets its mouse."""
    window = Gui.getMainWindow().findChild(QtGui.QMdiArea).activeSubWindow()
    return window.findChild(QtGui.QGraphicsView).viewport()


def plane_normal(points):
    """Normal of the plane that control points span; z where they span none."""
    array = np.array([tuple(p) for p in points], float).reshape(-1, 3)
    if len(array) >= 3:
        _, spread, axes = np.linalg.svd(array - array.mean(0), full_matrices=False)
        if spread[1] > 1e-6 * spread[0] > 0:
            return App.Vector(*axes[2])
    return App.Vector(0, 0, 1)
