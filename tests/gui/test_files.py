# SPDX-License-Identifier: LGPL-2.1-or-later
"""Imports and exports in the window: what is asked, made, recorded and refused."""

import importlib
import inspect
import json
import math

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import pytest
from PySide import QtGui

from BistableWB import exporters, make
from BistableWB.commands import importing, output
from BistableWB.objects import type_of
from BistableWB.objects.bistable_unit import tube_of

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
    gui(0.2)
    assert App.ActiveDocument.Objects == []
    press(QtGui.QDialogButtonBox.Ok, gui)
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
    path.write_text(SVG.format('<g id="Rail"><path d="M10 10H50"/><path d="M50.4 10H90"/></g>'))
    panel = importing.import_file(str(path))
    gui(0.3)
    table = panel.table

    def shown():
        return [[table.item(r, c).text() for c in (1, 2)] for r in range(table.rowCount())]

    assert shown() == [["", "316.1 mm"], ["Rail", "40 mm"], ["Rail", "39.6 mm"]]
    assert not table.item(0, 0).icon().isNull()
    assert "Unit: mm (width, height and viewBox of the picture)" in panel.receipt.text()
    panel.join.setValue(0.5)
    panel.scale.setValue(2)
    panel.refresh()
    assert shown() == [["", "632.2 mm"], ["Rail", "80 mm"], ["Rail", "79.2 mm"]]
    panel.join.setValue(0.81)
    panel.refresh()
    screenshot("import-curves")
    assert shown() == [["", "632.2 mm"], ["Rail", "159.2 mm"]]
    table.selectRow(1)
    press(QtGui.QDialogButtonBox.Ok, gui)
    assert not Gui.Control.activeDialog()
    assert App.ActiveDocument.Objects[-1].Length.Value == pytest.approx(159.2)


def test_a_drawing_of_unknown_size_asks_for_its_scale(gui, tmp_path):
    path = tmp_path / "old.svg"
    old = 'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" inkscape:version="0.48.5"'
    path.write_text(SVG.format("").replace('mm"', '"').replace("<svg", f"<svg {old}"))
    panel = importing.import_file(str(path))
    gui(0.2)
    assert "whose pixel is 1/90 inch" in panel.receipt.text()
    assert not panel.accept()
    panel.scale.setValue(1.066667)
    press(QtGui.QDialogButtonBox.Ok, gui)
    assert App.ActiveDocument.Objects[-1].Length.Value == pytest.approx(316.1 * 25.4 / 90, rel=1e-4)


def test_the_corner_radius_of_the_panel_rounds_the_curve(gui, tmp_path, screenshot, monkeypatch):
    recorded, do_command = [], Gui.doCommand
    monkeypatch.setattr(Gui, "doCommand", lambda line: (recorded.append(line), do_command(line)))
    path = tmp_path / "zigzag.svg"
    zigzag = "M0 0 L50 0 L50 50 L100 50 L100 90"
    path.write_text(SVG.format("").split("<path")[0] + f'<path d="{zigzag}"/></svg>')
    panel = importing.import_file(str(path))
    gui(0.3)
    field = panel.form.findChild(QtGui.QDoubleSpinBox, "CornerRadius")
    assert field.value() == 0
    assert "Radius by which kinks are rounded" in field.toolTip()
    field.setValue(10)
    gui(0.1)
    screenshot("import-corner-radius")
    press(QtGui.QDialogButtonBox.Ok, gui)
    curve = App.ActiveDocument.Objects[-1]
    assert curve.isValid()
    assert curve.CornerRadius.Value == 10
    straight, rounded = 190, 3 * (2 * 10 - 10 * math.pi / 2)
    assert curve.Length.Value == pytest.approx(straight - rounded, rel=1e-4)
    assert "curve.CornerRadius = 10" in recorded
    screenshot("imported-corner-radius")


def test_cancel_of_an_import_makes_nothing(gui, tmp_path):
    path = tmp_path / "one.csv"
    path.write_text("0,0\n60,40\n120,0\n")
    importing.import_file(str(path))
    gui(0.2)
    assert importing.import_file(str(path)) is None  # one panel at a time
    press(QtGui.QDialogButtonBox.Cancel, gui)
    assert not Gui.Control.activeDialog()
    assert App.ActiveDocument is None


def test_points_in_space_make_a_curve_of_kind_general(gui, tmp_path):
    path = tmp_path / "space.csv"
    path.write_text("0,0,0\n220,-60,20\n330,150,90\n160,320,60\n")
    assert importing.import_file(str(path)).accept()
    Gui.Control.closeDialog()
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


@pytest.mark.parametrize("suffix", exporters.FORMATS)
def test_the_panel_offers_options_that_exist(suffix):
    writer = __import__(
        f"BistableWB.exporters.{exporters.FORMATS[suffix].module}", fromlist=["write"]
    )
    entry, known = exporters.FORMATS[suffix], set(inspect.signature(writer.write).parameters)
    assert {*entry.keys, *entry.panel, *entry.options} == known - {"bodies", "path"}


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


def test_export_check_and_report_take_all_selected_prints(gui, asked, tmp_path, monkeypatch):
    doc = App.newDocument("Plate")
    coupons = [make.make_hinge_coupon(doc) for _ in "ab"]
    doc.recompute()
    for coupon in coupons:
        Gui.Selection.addSelection(coupon)
    path = tmp_path / "plate.stl"
    asked(path)
    Gui.runCommand("Bistable_ExportPrint")
    wanted = exporters.export(coupons, tmp_path / "wanted.stl")
    assert path.stat().st_size == wanted.stat().st_size
    Gui.runCommand("Bistable_Check")
    gui(0.3)
    boxes = Gui.getMainWindow().findChildren(QtGui.QWidget, "BistableCheck")
    assert len([box for box in boxes if box.isVisible()]) == 2
    press(QtGui.QDialogButtonBox.Close, gui)
    assert not Gui.Control.activeDialog()
