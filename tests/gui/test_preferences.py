# SPDX-License-Identifier: LGPL-2.1-or-later
"""Preferences: the page, what it changes, and what it never does; cancelled work."""

import FreeCAD as App
import FreeCADGui as Gui
import pytest
from PySide import QtCore, QtGui

from BistableWB import colours, make, settings
from BistableWB.origami.hinges.printers import PRINTERS
from BistableWB.origami.hinges.processes import PROCESSES
from BistableWB.scene import faces
from BistableWB.taskpanels import first_start


@pytest.fixture
def page(gui):
    from BistableWB.taskpanels.preferences import PreferencesPage

    yield PreferencesPage()
    for name in [*settings.NUMBERS]:
        settings.group().RemFloat(name)
    for name in ("Pivot", "Printer", "Process"):
        settings.group().RemString(name)
    for kind in colours.PANELS:
        settings.group().RemUnsigned(f"Colour_{kind}")


def test_the_page_keeps_what_is_chosen(page):
    assert page.numbers["BedWidth"].value() == 250
    page.numbers["BedWidth"].setValue(180)
    page.numbers["FaceThickness"].setValue(1.6)
    page.pivot.setCurrentIndex(1)
    page.saveSettings()
    assert settings.number("BedWidth") == 180
    assert settings.hinge_lines("h") == ["h.FaceThickness = 1.6", 'h.Pivot = "Pin"']
    page.loadSettings()
    assert page.numbers["FaceThickness"].value() == 1.6


def test_new_objects_follow_and_existing_ones_stay(gui, page):
    doc = App.newDocument("Old")
    units = make.make_bistable_unit(doc, theta=45, edge_length=60)
    old = make.make_hinge_set(doc, units)
    doc.recompute()
    size, shown = old.PrintSize, faces.face_colours(units.ViewObject)
    page.numbers["FaceThickness"].setValue(1.6)
    page.colours["primary"].setProperty("code", "#00AA00")
    page.saveSettings()
    old.touch()
    units.touch()
    doc.recompute()
    assert tuple(old.PrintSize) == pytest.approx(tuple(size), abs=0.2)
    assert faces.face_colours(units.ViewObject) == shown
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(units)
    Gui.runCommand("Bistable_HingeSet")
    new = doc.Objects[-1]
    assert new.FaceThickness.Value == 1.6
    assert colours.rgb("#00AA00") in [
        pytest.approx(c, abs=0.01) for c in set(faces.face_colours(new.ViewObject))
    ]


def test_the_bed_goes_into_new_hinge_sets_only(gui, page):
    doc = App.newDocument("Bed")
    units = make.make_bistable_unit(doc, theta=45, edge_length=60)
    old = make.make_hinge_set(doc, units)
    doc.recompute()
    page.numbers["BedWidth"].setValue(180)
    page.saveSettings()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(units)
    Gui.runCommand("Bistable_HingeSet")
    new = doc.Objects[-1]
    assert tuple(new.Bed) == (180, 210, 210)
    assert new.isValid(), new.getStatusString()
    old.touch()
    doc.recompute()
    assert tuple(old.Bed) == (0, 0, 0)
    page.numbers["BedWidth"].setValue(30)
    page.saveSettings()
    Gui.runCommand("Bistable_HingeSet")
    refused = doc.Objects[-1]
    assert "Bed" in refused.getStatusString()  # it is there, red, and says what to change
    assert tuple(refused.Bed) == (30, 210, 210)


def test_the_page_is_among_freecads_preferences(gui, screenshot):
    seen = []

    def look():
        dialog = QtGui.QApplication.activeModalWidget()
        if dialog is None:
            return
        pages = dialog.findChildren(QtGui.QWidget, "BistablePreferences")
        seen.append(len(pages))
        _open_page(dialog)
        gui(0.3)
        screenshot("preferences")
        dialog.reject()

    QtCore.QTimer.singleShot(1500, look)
    Gui.runCommand("Std_DlgPreferences")
    assert seen == [1]


def _open_page(dialog):
    for view in dialog.findChildren(QtGui.QListWidget):
        for row in range(view.count()):
            if "Bistable" in view.item(row).text():
                view.setCurrentRow(row)
    for tree in dialog.findChildren(QtGui.QTreeView):
        found = tree.model().match(
            tree.model().index(0, 0), QtCore.Qt.DisplayRole, "Bistable", 1,
            QtCore.Qt.MatchContains | QtCore.Qt.MatchRecursive,
        )  # fmt: skip
        if found:
            tree.setCurrentIndex(found[0])


@pytest.mark.provokes_errors
def test_cancelled_solids_leave_the_document_as_it_was(gui, escape, capfd):
    doc = App.newDocument("Mine")
    curve = make.make_curve(doc)
    triangles = make.make_triangle_placement(doc, curve)
    make.make_bistable_unit(doc, triangles)
    doc.recompute()
    names, count = [obj.Name for obj in doc.Objects], triangles.Count
    with escape(200) as pressed:
        Gui.runCommand("Bistable_HingeSet")
    gui(0.2)
    assert not pressed  # nothing is asked: Esc stops it
    assert [obj.Name for obj in doc.Objects] == names
    doc.recompute()
    assert triangles.Count == count
    assert triangles.Thickness.Value == 0
    assert doc.UndoCount == 0
    assert all(obj.isValid() for obj in doc.Objects)
    assert "cancelled" in capfd.readouterr().out


@pytest.mark.parametrize("name", PRINTERS)
def test_a_printer_gives_bed_nozzle_layers_and_process(page, name):
    page.printer.setCurrentIndex(page.printer.findData(name))
    page.printer.activated.emit(page.printer.currentIndex())
    page.saveSettings()
    profile = PRINTERS[name]
    assert settings.printer() == name
    assert settings.bed() == profile.bed
    assert settings.number("LayerHeight") == profile.layer
    assert settings.process() == profile.process
    doc = App.newDocument("Printed")
    unit = make.make_bistable_unit(doc, theta=45, edge_length=60)
    doc.recompute()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(unit)
    Gui.runCommand("Bistable_HingeSet")
    hinges = doc.Objects[-1]
    assert hinges.isValid()
    assert hinges.Process == profile.process
    assert tuple(hinges.Bed) == profile.bed
    assert hinges.LayerHeight.Value == profile.layer
    assert hinges.GapLength.Value == PROCESSES[profile.process].gives["gap_length"]


def test_a_number_of_ones_own_makes_it_a_custom_printer(page):
    page.printer.setCurrentIndex(page.printer.findData("Prusa MK4"))
    page.printer.activated.emit(page.printer.currentIndex())
    page.numbers["BedWidth"].setValue(180)
    page.saveSettings()
    assert settings.printer() == "Custom"
    assert settings.bed() == (180, 210, 220)


def test_the_printer_is_asked_for_once(page):
    settings.group().SetBool("PrinterAsked", False)
    question = first_start.ask()
    assert question.isVisible()
    assert not question.isModal()
    question.printer.setCurrentIndex(question.printer.findData("Creality Ender 3"))
    question.take.click()
    assert settings.bed() == (220, 220, 250)
    assert first_start.ask() is None
    settings.group().SetBool("PrinterAsked", False)
    first_start.ask().reject()
    assert settings.printer() == "Creality Ender 3"
    assert settings.printer_was_asked()


def test_the_air_that_a_calibration_plate_told_is_that_of_new_prints(page):
    settings.keep_calibration(air_layers=2)
    doc = App.newDocument("Aired")
    unit = make.make_bistable_unit(doc, theta=45, edge_length=60)
    doc.recompute()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(unit)
    Gui.runCommand("Bistable_HingeSet")
    hinges = doc.Objects[-1]
    assert hinges.isValid()
    assert hinges.AirLayers == 2
    settings.group().RemInt(settings.AIR_LAYERS)
