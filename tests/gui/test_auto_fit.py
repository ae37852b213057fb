# SPDX-License-Identifier: LGPL-2.1-or-later
"""Auto-fit in the window: search, stop, proposals, preview, OK, undo, macro."""

import math
import time

import FreeCAD as App
import FreeCADGui as Gui
import pytest
from PySide import QtCore, QtGui

from BistableWB import make
from BistableWB.objects import type_of

EDGE = make.NEW_TUBE["edge_length"]

_kept = {}  # the proposals of the example arch: searched once


def button(kind):
    boxes = Gui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
    return next(b for b in boxes if b.isVisible() and b.button(kind)).button(kind)


def shown(obj):
    return obj.ViewObject.SwitchNode.whichChild.getValue()


@pytest.fixture
def panel(gui, monkeypatch):
    """The panel that the command opens on the example tube; its search is left to the test."""
    from BistableWB.taskpanels.auto_fit import AutoFitPanel

    opened = []
    monkeypatch.setattr(AutoFitPanel, "start", lambda self: opened.append(self))
    Gui.runCommand("Bistable_NewTube")
    Gui.runCommand("Bistable_AutoFit")
    gui(0.2)
    monkeypatch.undo()
    yield opened[0]
    if Gui.Control.activeDialog():
        opened[0].reject()
        Gui.Control.closeDialog()
        gui()


def search(panel, gui):
    panel.start()
    end = time.monotonic() + 120
    while panel.button.text() == "Stop":
        assert time.monotonic() < end
        gui()


@pytest.fixture
def fitted(panel, gui):
    """The panel with the proposals for its curve."""
    if "fit" not in _kept:
        search(panel, gui)
        _kept["fit"] = panel.fit
    else:
        from BistableWB import fitting

        panel.course = fitting.course_of(panel.source)
        panel.show_fit(_kept["fit"])
    return panel


def test_proposals_are_listed_and_drawn_and_seen(fitted, gui, screenshot):
    doc, rows = App.ActiveDocument, fitted.fit.candidates
    assert fitted.message.isHidden()
    assert fitted.table.rowCount() == len(rows) == len(fitted.chart.points) >= 3
    assert fitted.chosen is rows[0]
    assert shown(doc.BistableUnit) == shown(doc.TrianglePlacement) == -1
    corners = fitted._shown._root
    assert corners.getNumChildren() > 5
    screenshot("auto-fit")
    fitted.table.selectRow(2)
    gui()
    assert fitted.chosen is rows[2]
    assert fitted.chart.chosen == {2}
    assert f"{rows[2].count} units" in fitted.details.text()
    fitted.form.repaint()
    place = fitted.chart.place_of(*fitted.chart.points[1]).toPoint()
    picked = QtGui.QMouseEvent(
        QtCore.QEvent.MouseButtonPress, QtCore.QPointF(place), QtCore.Qt.LeftButton,
        QtCore.Qt.LeftButton, QtCore.Qt.NoModifier,
    )  # fmt: skip
    QtGui.QApplication.sendEvent(fitted.chart, picked)
    nearest = fitted.chart.index_at(place)  # points may lie on each other
    assert fitted.chosen is rows[nearest]
    assert fitted.table.currentRow() == nearest


def test_the_preview_is_what_ok_makes(fitted, gui):
    from BistableWB import fitting
    from BistableWB.objects.bistable_unit import tube_of

    doc, chosen = App.ActiveDocument, fitted.chosen
    proposed = fitting.tube_of(chosen, fitted.course, fitted.fit.wanted).state(1.0)
    steps = doc.UndoNames
    button(QtGui.QDialogButtonBox.Ok).click()
    gui(0.2)
    assert not Gui.Control.activeDialog()
    assert doc.UndoNames == ["Auto-fit", *steps]
    assert all(obj.isValid() for obj in doc.Objects)
    assert doc.TrianglePlacement.Count == chosen.count
    assert doc.BistableUnit.RatioRule == chosen.rule
    assert abs(tube_of(doc.BistableUnit).state(1.0) - proposed).max() < 1e-9
    assert shown(doc.BistableUnit) != -1
    doc.undo()
    doc.recompute()
    assert doc.TrianglePlacement.EdgeLength.Value == EDGE
    doc.redo()
    assert doc.TrianglePlacement.EdgeLength.Value == pytest.approx(chosen.edge_length)


def test_cancel_leaves_everything_as_it_was(fitted, gui):
    doc = App.ActiveDocument
    view = Gui.ActiveDocument.ActiveView
    children, steps = view.getSceneGraph().getNumChildren(), doc.UndoNames
    button(QtGui.QDialogButtonBox.Cancel).click()
    gui(0.2)
    assert view.getSceneGraph().getNumChildren() == children - 1
    assert shown(doc.BistableUnit) != -1
    assert doc.UndoNames == steps
    assert doc.TrianglePlacement.EdgeLength.Value == EDGE


def test_ok_before_a_proposal_says_what_to_do(panel, gui):
    button(QtGui.QDialogButtonBox.Ok).click()
    gui()
    assert Gui.Control.activeDialog()
    assert "choose one of the proposals" in panel.message.text()


def test_wrong_wishes_are_told_beside_their_field(panel, gui, screenshot):
    panel.requirements.fields["height_ratio"].setValue(0)
    panel.start()
    assert "Height ratio is 0" in panel.requirements.errors["HeightRatio"].text()
    assert panel.requirements.errors["HeightRatio"].isVisibleTo(panel.form)
    screenshot("auto-fit-error")
    panel.requirements.fields["height_ratio"].setValue(2.5)
    for spin in panel.requirements.bed:
        spin.setValue(30)
    search(panel, gui)
    assert not panel.requirements.errors["HeightRatio"].isVisibleTo(panel.form)
    assert panel.message.text().startswith("Nothing fits.")
    assert panel.chosen is None


def test_a_search_can_be_stopped(panel, gui):
    panel.start()
    gui(0.3)
    panel.button.click()
    end = time.monotonic() + 20
    while panel.button.text() == "Stop":
        assert time.monotonic() < end
        gui()
    assert panel.message.text() == "Stopped."
    assert panel.fit is None


def test_wishes_come_from_the_hinge_set(gui):
    from BistableWB.taskpanels.auto_fit import AutoFitPanel

    doc = App.newDocument("Hinged")
    curve = make.make_curve(doc)
    units = make.make_bistable_unit(doc, make.make_triangle_placement(doc, curve))
    hinges = make.make_hinge_set(doc, units)
    hinges.FaceThickness, hinges.Bed = 2, App.Vector(180, 170, 160)
    wanted = AutoFitPanel(units.Triangles).requirements.wanted()
    assert (wanted.face_thickness, wanted.bed) == (2, (180, 170, 160))
    assert wanted.play == pytest.approx(0.4 / math.tan(math.radians(55)), abs=5e-3)


def test_a_bare_curve_gets_triangles_and_units_and_the_macro_replays(
    gui, fitted, monkeypatch, headless
):
    from BistableWB import fitting
    from BistableWB.taskpanels.auto_fit import AutoFitPanel

    recorded, do_command = [], Gui.doCommand
    monkeypatch.setattr(Gui, "doCommand", lambda line: (recorded.append(line), do_command(line)))
    doc = App.newDocument("Bare")
    Gui.runCommand("Bistable_Curve")
    panel = AutoFitPanel(doc.Curve)
    panel.course = fitting.course_of(doc.Curve)
    panel.show_fit(fitted.fit)
    panel.choose(1)
    assert panel.accept()
    types = [type_of(obj).partition("::")[2] for obj in doc.Objects]
    assert types == ["Curve", "TrianglePlacement", "BistableUnit"]
    assert doc.UndoNames == ["Auto-fit", "Curve"]
    expected = [doc.TrianglePlacement.Count, doc.BistableUnit.Shape.Area]
    lines = headless(
        "import FreeCAD as App, BistableWB\nApp.newDocument('Replay')\n"
        + "\n".join(recorded)
        + "\nprint('made', doc.TrianglePlacement.Count, doc.BistableUnit.Shape.Area, flush=True)\n"
    )
    (line,) = [line for line in lines if line.startswith("made ")]
    assert [float(x) for x in line.split()[1:]] == pytest.approx(expected)


def test_hinge_sets_follow_a_proposal(gui, fitted):
    """Their solids are made by a line of their own, not within the recompute."""
    from BistableWB import fitting
    from BistableWB.taskpanels.auto_fit import AutoFitPanel

    doc = App.ActiveDocument
    hinges = make.make_hinge_set(doc, doc.BistableUnit)
    hinges.FirstUnit = hinges.LastUnit = 1
    doc.recompute()
    panel = AutoFitPanel(doc.TrianglePlacement)
    panel.course = fitting.course_of(panel.source)
    panel.show_fit(fitted.fit)
    few = min(range(len(panel.fit.candidates)), key=lambda k: panel.fit.candidates[k].count)
    panel.choose(few)
    assert "make.make_solids(hinges)" in list(panel._lines())
    assert panel.accept()
    assert hinges.isValid(), hinges.getStatusString()
    assert doc.TrianglePlacement.Thickness.Value == pytest.approx(1.8)
    margins = panel.chosen.margin_min, fitted.fit.wanted.margin
    assert hinges.SnapMargins[0] > 0.9 * min(margins)


def test_ok_aims_at_what_the_tube_carries_beside_the_window(fitted, gui, monkeypatch):
    from BistableWB.taskpanels.aiming import AimButton
    from BistableWB.taskpanels.plots import dock

    doc, asked = App.ActiveDocument, []
    assert not fitted.aim.isEnabled()  # no hinges, no weight
    assert fitted.aim.asked() == {}
    hinges = make.make_hinge_set(doc, doc.BistableUnit)
    doc.recompute()
    fitted.hinges.append(hinges)
    fitted.aim.setEnabled(True)
    fitted.aim.kind.setCurrentIndex(1)
    fitted.aim.number.setValue(1.4)
    monkeypatch.setattr(AimButton, "_begin", lambda self: asked.append((self.obj, self._asked())))
    assert fitted.accept()
    assert asked == [(hinges, {"carry": 1.4})]
    assert dock().isVisible()
    dock().hide()
