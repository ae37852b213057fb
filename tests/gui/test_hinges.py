# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hinge set, coupon, export and check in the real window."""

import time

import FreeCAD as App
import FreeCADGui as Gui
import pytest
from PySide import QtGui

from BistableWB import make
from BistableWB.commands import output
from BistableWB.commands.base import fit_view
from BistableWB.objects import type_of
from BistableWB.scene import faces


def short_tube():
    """Four units."""
    doc = App.newDocument("Short")
    curve = make.make_curve(doc, points=[(0, 0, 0), (40, 80, 0), (110, 80, 0)])
    triangles = make.make_triangle_placement(doc, curve, edge_length=60)
    make.make_bistable_unit(doc, triangles)
    doc.recompute()
    return doc


def test_hinge_set_of_a_tube(gui, screenshot):
    doc = short_tube()
    start = time.perf_counter()
    Gui.runCommand("Bistable_HingeSet")
    print(f"hinge set of {doc.TrianglePlacement.Count} units: {time.perf_counter() - start:.1f} s")
    hinges = doc.Objects[-1]
    assert type_of(hinges) == "Bistable::HingeSet"
    assert hinges.isValid()
    assert not doc.BistableUnit.ViewObject.Visibility
    assert doc.UndoNames == ["Hinge set"]
    shown = faces.face_colours(hinges.ViewObject)
    assert len(shown) == hinges.BodyCount
    assert len(set(shown)) == 5  # four kinds of panels, and links
    screenshot("hinge-set")
    hinges.Deployment = 1
    doc.recompute()
    gui()
    fit_view(isometric=True)
    screenshot("hinge-set-deployed")


def test_bodies_of_a_file_of_before_they_had_kinds_are_coloured_by_what_they_are():
    """Their names, which version 0.1 gave them, are read once."""
    doc = App.newDocument()
    coupon = make.make_hinge_coupon(doc)
    coupon.BodyNames = ["unit01_secondary_left_upper", "block12_13", "strip_AB", "unit02_link_B"]
    for name in ("BodyKinds", "BodyUnits"):
        coupon.removeProperty(name)
    coupon.Proxy.onDocumentRestored(coupon)
    assert coupon.BodyKinds == ["secondary", "block", "flexure", "link"]
    assert coupon.BodyUnits == [1, 12, 1, 2]
    App.closeDocument(doc.Name)


def test_coupon_export_and_check(gui, screenshot, tmp_path, capfd):
    Gui.runCommand("Bistable_HingeCoupon")
    doc = App.ActiveDocument
    (coupon,) = doc.Objects
    assert coupon.isValid(), coupon.getStatusString()
    target = tmp_path / "coupon.3mf"
    output.write(coupon, str(target))
    assert target.stat().st_size > 1000
    assert "was written to" in capfd.readouterr().out
    from BistableWB import settings

    assert settings.group().GetString("ExportFolder") == str(tmp_path)
    Gui.runCommand("Bistable_Check")
    gui(0.2)
    form = Gui.getMainWindow().findChild(QtGui.QWidget, "BistableCheck")
    wait_for_check(form, gui)
    screenshot("check-coupon")
    text = "\n".join(label.text() for label in form.findChildren(QtGui.QLabel))
    Gui.Control.closeDialog()
    gui()
    assert "Error:" not in text
    assert "✓" in text


def wait_for_check(form, gui, seconds=120):
    end = time.monotonic() + seconds
    state = form.findChild(QtGui.QLabel, "State")
    while "print" not in state.text() and "correct" not in state.text():
        assert time.monotonic() < end
        gui(0.2)


def test_an_export_that_cannot_be_says_why(gui, tmp_path, capfd):
    Gui.runCommand("Bistable_HingeCoupon")
    output.write(App.ActiveDocument.Objects[0], str(tmp_path / "missing" / "x.stl"))
    assert "There is no folder" in capfd.readouterr().err


def test_the_file_dialog_is_asked_for_a_name(gui, monkeypatch, tmp_path):
    Gui.runCommand("Bistable_HingeCoupon")
    asked = []

    def answer(parent, title, start, filters):
        asked.append((start, filters))
        return str(tmp_path / "print"), "STL (*.stl)"

    monkeypatch.setattr(QtGui.QFileDialog, "getSaveFileName", answer)
    Gui.runCommand("Bistable_ExportPrint")
    assert (tmp_path / "print.stl").exists()
    assert asked[0][1].startswith("3MF (*.3mf);;STL (*.stl)")


@pytest.mark.parametrize("name", ["HingeSet", "ExportPrint", "Check"])
def test_commands_wait_for_something_to_work_on(gui, name):
    from BistableWB.commands import COMMANDS

    App.newDocument("Empty")
    command = next(c for c in COMMANDS if c.name == f"Bistable_{name}")
    assert not command.IsActive()


def test_inputs_stay_in_view_where_the_hinges_are_refused(gui):
    """A set whose input is refused is Touched, which FreeCAD calls valid: the view was empty."""
    doc = App.newDocument("Refused")
    curve = make.make_curve(doc)
    triangles = make.make_triangle_placement(doc, curve, edge_length=900)  # longer than the curve
    unit = make.make_bistable_unit(doc, triangles)
    doc.recompute()
    assert not triangles.isValid()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(unit)
    Gui.runCommand("Bistable_HingeSet")
    gui(0.2)
    hinges = doc.Objects[-1]
    assert not hinges.Shape.Solids
    assert curve.ViewObject.Visibility
    triangles.EdgeLength = 60
    doc.recompute()
    assert hinges.Shape.Solids
