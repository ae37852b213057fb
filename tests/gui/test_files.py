# SPDX-License-Identifier: LGPL-2.1-or-later
"""Imports and exports in the window: what is asked, made, recorded and refused."""

import importlib
import inspect
import json

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import pytest
from PySide import QtGui

from BistableWB import exporters, make
from BistableWB.commands import importing, output
from BistableWB.objects import type_of
from BistableWB.objects.bistable_unit import tube_of
from BistableWB.taskpanels.export import OPTIONS

SVG = """<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="200mm" viewBox="0 0 300 200">
<path d="M0 150 C 60 30 180 30 240 150"/>{}</svg>"""


@pytest.fixture
def asked(monkeypatch):
    """``asked(path, pattern)``: what the user answers to file dialogs; returns the questions."""
    questions = []

    def answer(path, pattern=""):
        def reply(parent, title, start, kinds):
            questions.append(kinds.split(";;"))
            return str(path), pattern

        monkeypatch.setattr(QtGui.QFileDialog, "getSaveFileName", reply)
        monkeypatch.setattr(QtGui.QFileDialog, "getOpenFileName", reply)
        return questions

    return answer


def press(kind, gui):
    boxes = Gui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
    next(b for b in boxes if b.isVisible() and b.button(kind)).button(kind).click()
    gui()


def test_a_drawing_becomes_a_curve_in_one_step(gui, asked, tmp_path, monkeypatch):
    path = tmp_path / "arch.svg"
    path.write_text(SVG.format(""))
    asked(path)
    recorded, do_command = [], Gui.doCommand
    monkeypatch.setattr(Gui, "doCommand", lambda line: (recorded.append(line), do_command(line)))
    Gui.runCommand("Bistable_Import")
    doc = App.ActiveDocument
    curve = doc.Objects[-1]
    assert type_of(curve) == "Bistable::Curve"
    assert curve.isValid(), curve.getStatusString()
    assert (curve.Kind, doc.UndoNames) == ("Plane", ["Import curve"])
    length = curve.Length.Value
    doc.undo()
    assert doc.Objects == []
    namespace = {}
    exec("import FreeCAD as App\n" + "\n".join(recorded), namespace)
    assert namespace["curve"].Length.Value == pytest.approx(length)


def test_of_several_curves_one_is_chosen(gui, tmp_path, screenshot):
    path = tmp_path / "two.svg"
    path.write_text(SVG.format('<path d="M10 10 L 90 10"/>'))
    menu = importing.import_file(str(path))
    gui()
    texts = [action.text() for action in menu.actions()]
    assert texts == ["Curve 1: 316.1 mm", "Curve 2: 80 mm"]
    menu.actions()[1].trigger()
    menu.close()
    assert App.ActiveDocument.Objects[-1].Length.Value == pytest.approx(80)


def test_points_in_space_make_a_curve_of_kind_general(gui, tmp_path):
    path = tmp_path / "space.csv"
    path.write_text("0,0,0\n220,-60,20\n330,150,90\n160,320,60\n")
    assert importing.import_file(str(path)) is None
    curve = App.ActiveDocument.Objects[-1]
    assert curve.Kind == "General"
    assert curve.isValid(), curve.getStatusString()


def test_a_file_that_is_no_curve_says_why(gui, tmp_path, capfd):
    path = tmp_path / "no.svg"
    path.write_text("nothing")
    importing.import_file(str(path))
    assert "is not a whole SVG file" in capfd.readouterr().err
    assert App.ActiveDocument is None


def test_units_come_back_from_fold(gui, tmp_path):
    doc = App.newDocument("Tube")
    curve = make.make_curve(doc)
    units = make.make_bistable_unit(
        doc, make.make_triangle_placement(doc, curve, edge_length=80), ratio=0.6
    )
    doc.recompute()
    path = tmp_path / "tube.fold"
    exporters.export(units, path)
    App.newDocument("Back")
    importing.import_file(str(path))
    back = App.ActiveDocument.Objects
    assert len(back) == units.Triangles.Count > 2
    assert sum(unit.Shape.Area for unit in back) == pytest.approx(units.Shape.Area)
    box = App.BoundBox()
    for unit in back:
        box.add(unit.Shape.BoundBox)
    assert box.Center.distanceToPoint(units.Shape.BoundBox.Center) < 1e-6
    assert App.ActiveDocument.UndoNames == ["Import units"]


def test_freecads_own_import_and_export_know_fold(unit, tmp_path):
    assert App.getImportType("fold") == ["BistableWB.imports.fold"]
    assert App.getExportType("fold") == ["BistableWB.exporters"]
    path = str(tmp_path / "unit.fold")
    importlib.import_module(App.getExportType("fold")[0]).export([unit], path)
    importlib.import_module(App.getImportType("fold")[0]).insert(path, unit.Document.Name)
    back = unit.Document.Objects[-1]
    assert back is not unit
    assert back.Shape.Area == pytest.approx(unit.Shape.Area)


@pytest.mark.parametrize("suffix", OPTIONS)
def test_the_panel_offers_options_that_exist(suffix):
    writer = __import__(f"BistableWB.exporters.{exporters.FORMATS[suffix]}", fromlist=["write"])
    assert set(OPTIONS[suffix]) <= set(inspect.signature(writer.write).parameters)


def test_nets_are_written_with_the_options_of_the_panel(unit, gui, asked, screenshot, tmp_path):
    path = tmp_path / "net.svg"
    asked(path, "SVG (*.svg)")
    Gui.runCommand("Bistable_ExportPrint")
    gui(0.2)
    window = Gui.getMainWindow()
    assert not path.exists()
    assert not window.findChild(QtGui.QDoubleSpinBox, "tab_depth").isEnabled()
    window.findChild(QtGui.QCheckBox, "tabs").setChecked(True)
    window.findChild(QtGui.QDoubleSpinBox, "tab_depth").setValue(9)
    window.findChild(QtGui.QComboBox, "sheet").setCurrentIndex(3)
    screenshot("export-svg")
    press(QtGui.QDialogButtonBox.Ok, gui)
    assert not Gui.Control.activeDialog()
    wanted = tmp_path / "wanted.svg"
    exporters.export(unit, wanted, sheet="A2", tabs=True, tab_depth=9)
    assert path.read_text() == wanted.read_text()


def test_a_fold_file_gets_its_frames_and_cancel_writes_none(unit, gui, asked, screenshot, tmp_path):
    path = tmp_path / "unit.fold"
    asked(path)
    Gui.runCommand("Bistable_ExportPrint")
    gui(0.2)
    screenshot("export-fold")
    press(QtGui.QDialogButtonBox.Cancel, gui)
    assert not path.exists()
    Gui.runCommand("Bistable_ExportPrint")
    gui(0.2)
    Gui.getMainWindow().findChild(QtGui.QSpinBox, "deployment_frames").setValue(4)
    Gui.getMainWindow().findChild(QtGui.QLineEdit, "title").setText("Mine")
    press(QtGui.QDialogButtonBox.Ok, gui)
    content = json.loads(path.read_text(encoding="utf-8"))
    assert (len(content["file_frames"]), content["file_title"]) == (1 + 4 + 2, "Mine")


def test_a_state_is_chosen_with_the_format(unit, asked, tmp_path):
    questions = asked(tmp_path / "flat", "STEP, flat (*.step)")
    Gui.runCommand("Bistable_ExportPrint")
    assert {"STEP (*.step)", "STEP, flat (*.step)", "STL, deployed (*.stl)"} <= set(questions[0])
    import Part

    flat = Part.read(str(tmp_path / "flat.step"))
    assert flat.Area == pytest.approx(unit.Shape.Area)
    height = np.ptp(tube_of(unit).state(0)[..., 2])
    assert flat.BoundBox.ZLength == pytest.approx(height, abs=1e-6)
    assert unit.Shape.BoundBox.ZLength < height - 5
    hinges = make.make_hinge_set(unit.Document, unit)
    unit.Document.recompute()
    Gui.Selection.clearSelection()
    asked("")
    assert output.ask_for_path(hinges) == ("", {})
    assert "STL, flat (*.stl)" not in questions[-1]  # a print is flat anyway
    assert "STL, deployed (*.stl)" in questions[-1]
