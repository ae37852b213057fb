# SPDX-License-Identifier: LGPL-2.1-or-later
"""Control points in the 3D view, by a simulated mouse."""

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
from PySide import QtCore, QtGui

from BistableWB import make
from BistableWB.scene.camera import Camera
from BistableWB.scene.handles import canvas_of_active_view as canvas
from BistableWB.scene.handles import plane_normal


def pixel_of(point):
    """Where a point of space is in the canvas."""
    camera = Camera(Gui.ActiveDocument.ActiveView, canvas().width() / canvas().height())
    x, y = camera.project(point)
    return QtCore.QPoint(round(x * canvas().width()), round((1 - y) * canvas().height()))


@pytest.mark.parametrize("kind", ["Orthographic", "Perspective"])
def test_the_camera_finds_what_it_shows(gui, kind):
    App.newDocument("Mine")
    view = Gui.ActiveDocument.ActiveView
    view.setCameraType(kind)
    view.viewIsometric()
    gui(0.5)
    camera = Camera(view, 1.5)
    point = App.Vector(3, 5, -2)
    start, along = camera.ray(camera.project(point))
    assert (point - start).cross(along).Length < 1e-4
    x, y = camera.project(view.getPoint(*[side // 2 for side in view.getSize()]))
    assert (x, y) == pytest.approx((0.5, 0.5), abs=0.01)
    view.setCameraType("Orthographic")


@pytest.fixture
def clean(gui):
    yield gui
    if Gui.Control.activeDialog():
        Gui.Control.activeDialog()
        Gui.ActiveDocument.resetEdit()
        Gui.Control.closeDialog()
    gui()


def press(button, gui):
    boxes = Gui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
    box = next(b for b in boxes if b.isVisible() and b.button(button))
    box.button(button).click()
    gui(0.2)


def test_a_curve_is_drawn_by_clicks_and_the_zigzag_follows(clean, mouse, screenshot):
    gui = clean
    Gui.runCommand("Bistable_DrawCurve")
    gui(0.5)
    doc = App.ActiveDocument
    curve, triangles = doc.Objects
    size = canvas().size()
    corners = [(0.2, 0.8), (0.35, 0.2), (0.65, 0.2), (0.8, 0.8)]
    for x, y in corners:
        mouse.click(canvas(), QtCore.QPoint(int(x * size.width()), int(y * size.height())))
    gui(0.3)
    assert len(curve.Points) == 4
    assert all(abs(p.z) < 1e-6 for p in curve.Points)
    assert curve.isValid()
    assert triangles.isValid(), triangles.getStatusString()
    assert triangles.Count > 3
    screenshot("draw-curve")
    before, count = curve.Points[1], triangles.Count
    start = pixel_of(before)
    mouse.drag(canvas(), start, start + QtCore.QPoint(0, 150))
    gui(0.3)
    assert len(curve.Points) == 4
    assert (curve.Points[1] - before).Length > 10
    assert curve.Points[2] == curve.Points[2]
    assert triangles.Count != count or triangles.isValid()
    mouse.click(canvas(), pixel_of(curve.Points[3]), mouse.RIGHT)
    gui(0.2)
    assert len(curve.Points) == 3
    press(QtGui.QDialogButtonBox.Ok, gui)
    assert doc.UndoNames == ["Draw curve"]
    doc.undo()
    assert doc.Objects == []


def test_cancelled_drawing_leaves_nothing(clean, mouse):
    gui = clean
    App.newDocument("Mine")
    Gui.runCommand("Bistable_DrawCurve")
    gui(0.3)
    mouse.click(canvas(), canvas().rect().center())
    press(QtGui.QDialogButtonBox.Cancel, gui)
    assert App.ActiveDocument.Objects == []


def test_points_on_a_sphere_are_dragged_on_it(clean, mouse, screenshot):
    gui = clean
    Gui.runCommand("Bistable_CurveOnSphere")
    Gui.runCommand("Bistable_Units")
    doc = App.ActiveDocument
    Gui.ActiveDocument.ActiveView.viewTop()
    gui(0.5)
    Gui.ActiveDocument.setEdit(doc.Curve.Name)
    gui(0.3)
    proxy_points = doc.Curve.Points
    start = pixel_of(doc.Curve.Shape.Vertexes[0].Point)
    screenshot("draw-on-sphere")
    mouse.drag(canvas(), start, start + QtCore.QPoint(-10, 12))
    gui(0.3)
    moved = doc.Curve.Points[0]
    assert (moved - proxy_points[0]).Length > 1
    assert moved.z == 0
    assert doc.Curve.isValid()
    press(QtGui.QDialogButtonBox.Cancel, gui)
    assert doc.Curve.Points == proxy_points


def test_the_plane_of_points():
    assert plane_normal([]) == App.Vector(0, 0, 1)
    tilted = [App.Vector(0, 0, 0), App.Vector(0, 50, 0), App.Vector(0, 50, 50)]
    assert abs(plane_normal(tilted).x) == pytest.approx(1)


def test_a_tube_in_another_plane_stays_in_it(clean, mouse):
    gui = clean
    doc = App.newDocument("Upright")
    make.make_curve(doc, points=[(0, 0, 0), (0, 0, 120), (200, 0, 120), (200, 0, 0)])
    doc.recompute()
    Gui.ActiveDocument.ActiveView.viewFront()
    Gui.ActiveDocument.ActiveView.fitAll()
    Gui.ActiveDocument.setEdit("Curve")
    gui(0.5)
    start = pixel_of(doc.Curve.Points[1])
    mouse.drag(canvas(), start, start + QtCore.QPoint(30, -40))
    gui(0.3)
    assert doc.Curve.Points[1].y == pytest.approx(0, abs=1e-6)
    assert doc.Curve.Points[1] != App.Vector(0, 0, 120)
    press(QtGui.QDialogButtonBox.Ok, gui)
    assert doc.Curve.isValid()


@pytest.fixture
def edited(clean):
    """A Curve in the plane z = 0, seen from above, whose panel is open."""
    doc = App.newDocument("Edited")
    curve = make.make_curve(doc)
    doc.recompute()
    Gui.ActiveDocument.ActiveView.viewTop()
    Gui.ActiveDocument.ActiveView.fitAll()
    clean(0.5)
    Gui.ActiveDocument.setEdit(curve.Name)
    clean(0.3)
    return curve


def test_a_point_does_not_stick_to_the_mouse_whose_release_was_lost(edited, mouse):
    start = pixel_of(edited.Points[1])
    mouse.move(canvas(), start)
    mouse.press(canvas(), start)
    mouse.move(canvas(), start + QtCore.QPoint(20, 30), mouse.LEFT)
    left = edited.Points
    for away in (60, 90):  # FreeCAD computes, and swallows the release
        mouse.move(canvas(), start + QtCore.QPoint(away, away))
    assert edited.Points == left
    again = pixel_of(left[1])
    mouse.drag(canvas(), again, again + QtCore.QPoint(-20, 0))
    assert edited.Points[1] != left[1]


def test_points_of_a_curve_that_follows_a_wire_are_neither_shown_nor_dragged(edited, mouse, gui):
    doc = edited.Document
    panel = Gui.getMainWindow().findChild(QtGui.QWidget, "BistablePanel")
    table = panel.findChild(QtGui.QTableWidget, "PointsTable")
    assert table.isVisible()
    points, start = edited.Points, pixel_of(edited.Points[1])
    wire = doc.addObject("Part::Feature", "Wire")
    corners = [App.Vector(0, 0), App.Vector(0, 80), App.Vector(200, 80), App.Vector(200, 0)]
    wire.Shape = bezier(corners)
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(wire)
    panel.findChild(QtGui.QPushButton, "UseSelection").click()
    gui(0.3)
    assert edited.Source[0] is wire
    assert not table.isVisible()
    mouse.drag(canvas(), start, start + QtCore.QPoint(30, 30))
    assert edited.Points == points


def bezier(corners):
    """Shape of a Bézier curve."""
    curve = Part.BezierCurve()
    curve.setPoles(corners)
    return curve.toShape()
