# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panels of the objects: open, edit, live preview, cancel, OK, undo, redo, refusals."""

import FreeCAD as App
import FreeCADGui as Gui
import pytest
from PySide import QtGui

from BistableWB import make

EDGE = make.NEW_TUBE["edge_length"]


@pytest.fixture
def tube(gui):
    Gui.runCommand("Bistable_NewTube")
    gui()
    yield App.ActiveDocument
    Gui.Control.closeDialog()
    gui()


def open_panel(obj, gui):
    obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
    gui(0.2)
    form = Gui.getMainWindow().findChild(QtGui.QWidget, "BistablePanel")
    assert form is not None
    return form


def press(button, gui):
    box = next(
        b for b in Gui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
        if b.isVisible() and b.button(button)
    )  # fmt: skip
    box.button(button).click()
    gui(0.3)


OK, CANCEL = QtGui.QDialogButtonBox.Ok, QtGui.QDialogButtonBox.Cancel


def type_into(form, name, text, gui):
    field = form.findChild(QtGui.QAbstractSpinBox, name)
    field.findChild(QtGui.QLineEdit).setText(text)
    gui(0.4)


def error_of(form, name):
    label = form.findChild(QtGui.QLabel, f"{name}_error")
    return label.text() if label.isVisible() else ""


def panel_is_open():
    return bool(Gui.Control.activeDialog())


def test_ok_keeps_the_change_as_one_undo_step(gui, tube, screenshot):
    triangles, units = tube.TrianglePlacement, tube.BistableUnit
    before = triangles.Count
    assert triangles.EdgeLength.Value == EDGE
    form = open_panel(triangles, gui)
    type_into(form, "EdgeLength", "55 mm", gui)
    assert triangles.EdgeLength.Value == 55
    assert triangles.Count > before  # live: shorter units, more of them
    assert len(units.Shape.Faces) == 12 * triangles.Count
    screenshot("panel-triangles")
    press(OK, gui)
    assert not panel_is_open()
    assert tube.UndoNames[0] == f"Edit {triangles.Label}"
    tube.undo()
    tube.recompute()
    assert (triangles.EdgeLength.Value, triangles.Count) == (EDGE, before)
    tube.redo()
    tube.recompute()
    assert triangles.EdgeLength.Value == 55


def test_cancel_leaves_everything_as_it_was(gui, tube):
    triangles, before = tube.TrianglePlacement, tube.TrianglePlacement.Count
    steps = tube.UndoNames
    form = open_panel(triangles, gui)
    type_into(form, "EdgeLength", "55 mm", gui)
    press(CANCEL, gui)
    assert not panel_is_open()
    assert (triangles.EdgeLength.Value, triangles.Count) == (EDGE, before)
    assert len(tube.BistableUnit.Shape.Faces) == 12 * before
    assert tube.UndoNames == steps


def test_a_refused_input_is_explained_beside_its_field(gui, tube, screenshot):
    units = tube.BistableUnit
    form = open_panel(units, gui)
    type_into(form, "Ratio", "0.01", gui)
    assert "Ratio" in error_of(form, "Ratio")
    screenshot("panel-refused")
    press(OK, gui)
    assert panel_is_open()  # not accepted
    type_into(form, "Ratio", "0.8", gui)
    assert error_of(form, "Ratio") == ""
    press(OK, gui)
    assert not panel_is_open()
    assert units.RatioRule == "Fixed"


def test_length_takes_units_and_formulas(gui, tube):
    triangles = tube.TrianglePlacement
    form = open_panel(triangles, gui)
    type_into(form, "EdgeLength", "5 cm", gui)
    assert triangles.EdgeLength.Value == pytest.approx(50)
    triangles.setExpression("EdgeLength", "Curve.Length / 10")
    tube.recompute()
    press(OK, gui)
    assert triangles.EdgeLength.Value == pytest.approx(tube.Curve.Length.Value / 10)
    form = open_panel(triangles, gui)
    type_into(form, "Gamma", "25 deg", gui)
    press(OK, gui)
    assert triangles.EdgeLength.Value == pytest.approx(tube.Curve.Length.Value / 10)
    assert triangles.Gamma.Value == 25


def test_inputs_that_do_not_count_are_not_shown(gui, tube):
    form = open_panel(tube.BistableUnit, gui)
    assert not form.findChild(QtGui.QWidget, "Theta").isVisible()
    assert form.findChild(QtGui.QWidget, "HeightRatio").isVisible()
    press(CANCEL, gui)


def test_fields_follow_the_rule_that_they_belong_to(gui, tube):
    form = open_panel(tube.BistableUnit, gui)
    rules = form.findChild(QtGui.QComboBox, "RatioRule")
    fields = {"Adaptive": "RatioShare", "Fixed": "Ratio", "TargetSnap": "TargetMargin"}
    for rule, name in fields.items():
        rules.setCurrentIndex(rules.findData(rule))
        shown = [one for one in fields.values() if form.findChild(QtGui.QWidget, one).isVisible()]
        assert shown == [name]
    press(CANCEL, gui)


def folds(form):
    """The groups of a panel that can be folded."""
    return {
        group.findChild(QtGui.QToolButton).text(): group
        for group in form.findChildren(QtGui.QWidget)
        if group.objectName().endswith("_group") and group.isVisible()
    }


def test_a_panel_has_its_basic_values_on_one_screen_and_the_rest_folded(gui, tube, screenshot):
    hinges = make.make_hinge_set(tube, make.make_bistable_unit(tube, theta=45, edge_length=60))
    tube.recompute()
    for obj in (tube.TrianglePlacement, tube.BistableUnit, hinges):
        form = open_panel(obj, gui)
        assert form.height() <= 500, obj.Name  # of 720 the window's bars take the rest
        assert folds(form).keys() >= {"Results"}
        press(CANCEL, gui)
    form = open_panel(hinges, gui)
    inside = form.findChild(QtGui.QWidget, "SegmentWidth")
    assert form.findChild(QtGui.QWidget, "FaceThickness").isVisible()
    assert not inside.isVisible()
    screenshot("panel-folded")
    folds(form)["Hinge"].findChild(QtGui.QToolButton).click()
    assert inside.isVisible()
    press(CANCEL, gui)
    form = open_panel(hinges, gui)  # it stays as the user left it
    assert form.findChild(QtGui.QWidget, "SegmentWidth").isVisible()
    folds(form)["Hinge"].findChild(QtGui.QToolButton).click()
    press(CANCEL, gui)


def test_a_refused_input_unfolds_its_group(gui, unit):
    form = open_panel(unit, gui)
    assert not form.findChild(QtGui.QWidget, "Omega").isVisible()
    type_into(form, "Omega", "0 deg", gui)
    assert "Omega" in error_of(form, "Omega") or "ω" in error_of(form, "Omega")
    press(CANCEL, gui)


def test_points_of_a_curve_are_typed(gui, tube, screenshot):
    form = open_panel(tube.Curve, gui)
    table = form.findChild(QtGui.QTableWidget, "PointsTable")
    table.item(1, 1).setText("90")
    gui(0.4)
    assert tube.Curve.Points[1].y == 90
    screenshot("panel-curve")
    press(OK, gui)
    assert all(obj.isValid() for obj in tube.Objects)


def test_heavy_solids_wait_for_apply(gui, screenshot):
    doc = App.newDocument("Heavy")
    units = make.make_bistable_unit(doc, theta=45, edge_length=60)
    hinges = make.make_hinge_set(doc, units)
    doc.recompute()
    size = hinges.PrintSize
    Gui.ActiveDocument.ActiveView.viewIsometric()
    Gui.ActiveDocument.ActiveView.fitAll()
    form = open_panel(hinges, gui)
    type_into(form, "FaceThickness", "2 mm", gui)
    assert hinges.PrintSize == size
    form.findChild(QtGui.QPushButton, "Apply").click()
    gui()
    assert hinges.PrintSize.z > size.z
    screenshot("panel-hinges")
    type_into(form, "GapLength", "0.05 mm", gui)
    form.findChild(QtGui.QPushButton, "Apply").click()
    gui()
    assert "Gap length" in error_of(form, "GapLength")
    press(CANCEL, gui)
    assert hinges.FaceThickness.Value == 1.2
    assert hinges.PrintSize == size
    assert hinges.isValid()


def test_units_followed_live_do_not_drag_the_solids_along(gui):
    doc = App.newDocument("Heavy")
    units = make.make_bistable_unit(doc, theta=45, edge_length=60)
    hinges = make.make_hinge_set(doc, units)
    doc.recompute()
    faces = len(hinges.Shape.Faces)
    form = open_panel(units, gui)
    type_into(form, "EdgeLength", "80 mm", gui)
    assert units.Shape.BoundBox.XLength > 0
    assert "Touched" in hinges.State
    press(CANCEL, gui)
    assert "Touched" not in hinges.State
    assert len(hinges.Shape.Faces) == faces
    assert units.EdgeLength.Value == 60


def test_a_double_click_in_the_tree_edits_in_one_step(gui, tube, mouse, screenshot):
    from PySide import QtCore

    window = Gui.getMainWindow()
    tree = next(t for t in window.findChildren(QtGui.QTreeWidget) if t.inherits("Gui::TreeWidget"))
    tree.expandAll()
    gui(0.3)
    (item,) = tree.findItems("TrianglePlacement", QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive)
    tree.scrollToItem(item)
    where = tree.visualItemRect(item).center()
    if not tree.viewport().isVisible() or not tree.viewport().rect().contains(where):
        screenshot("tree")  # brings the tree to the front
        where = tree.visualItemRect(item).center()
    steps = tube.UndoNames
    mouse.double_click(tree.viewport(), where)
    gui(0.3)
    form = window.findChild(QtGui.QWidget, "BistablePanel")
    assert form is not None
    type_into(form, "EdgeLength", "55 mm", gui)
    press(OK, gui)
    assert tube.UndoNames == ["Edit TrianglePlacement", *steps]
    tube.undo()
    assert tube.TrianglePlacement.EdgeLength.Value == EDGE


def test_what_a_panel_changed_is_recorded(gui, tube, monkeypatch):
    recorded, do_command = [], Gui.doCommand
    monkeypatch.setattr(Gui, "doCommand", lambda line: (recorded.append(line), do_command(line)))
    form = open_panel(tube.TrianglePlacement, gui)
    type_into(form, "EdgeLength", "55 mm", gui)
    press(OK, gui)
    assert recorded[1:] == ["doc.TrianglePlacement.EdgeLength = 55.0"]
    assert tube.TrianglePlacement.Tolerance.Value == pytest.approx(0.55)  # went along by itself
    recorded.clear()
    form = open_panel(tube.TrianglePlacement, gui)
    type_into(form, "Tolerance", "2 mm", gui)
    type_into(form, "EdgeLength", "50 mm", gui)
    press(OK, gui)
    assert recorded[1:] == [
        "doc.TrianglePlacement.EdgeLength = 50.0",
        "doc.TrianglePlacement.Tolerance = 2.0",
    ]
    recorded.clear()
    form = open_panel(tube.Curve, gui)
    form.findChild(QtGui.QTableWidget, "PointsTable").item(1, 1).setText("90")
    gui(0.3)
    press(OK, gui)
    assert "App.Vector(60.0, 90.0, 0.0)" in recorded[1]
