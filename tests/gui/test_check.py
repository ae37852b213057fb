# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of the checks: findings, the worst first, each shown in the 3D view."""

import os
import time

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
import pytest
from pivy import coin
from PySide import QtGui

from BistableWB import make
from BistableWB.commands.base import fit_view
from BistableWB.origami.errors import ERROR, NOTE, WARNING, Finding, phrase
from BistableWB.programs import openscad
from BistableWB.scene.pointer import Pointer, elements_of
from BistableWB.taskpanels.check import CheckPanel


@pytest.fixture
def hinges(gui):
    """HingeSet of one unit that nobody has told to compensate."""
    doc = App.newDocument("Check")
    unit = make.make_bistable_unit(doc, theta=45, ratio=0.42, edge_length=60)
    obj = make.make_hinge_set(doc, unit)
    obj.Segmentations, obj.Compensate = 3, False
    doc.recompute()
    assert obj.isValid(), obj.getStatusString()
    unit.ViewObject.Visibility = False
    gui()
    return obj


@pytest.fixture
def coupon(gui):
    """HingeCoupon, which is checked in a moment."""
    obj = make.make_hinge_coupon(App.newDocument("Coupon"))
    obj.FaceThickness, obj.LayerHeight = 1.2, 0.2
    obj.Document.recompute()
    gui()
    return obj


@pytest.fixture
def panel_of(gui):
    """``panel_of(obj)``: the panel, its checks done."""

    def show(obj):
        made = CheckPanel(obj)
        Gui.Control.showDialog(made)
        wait(made, gui)
        return made

    yield show
    Gui.Control.closeDialog()
    gui()


def wait(panel, gui, seconds=120):
    end = time.monotonic() + seconds
    gui(0.2)
    while not panel.done:
        assert time.monotonic() < end
        gui(0.1)


def rows(panel):
    """(text, button that shows it or None) of the findings that are shown."""
    found = []
    for k in range(panel.list.count()):
        row = panel.list.itemAt(k).widget()
        if not row.isHidden():
            text = row.findChild(QtGui.QLabel).text()
            found.append((text, row.findChild(QtGui.QToolButton, "Show")))
    return found


def marks(scene):
    """Points that are marked over everything in the view."""
    search = coin.SoSearchAction()
    search.setType(coin.SoMarkerSet.getClassTypeId())
    search.apply(scene)
    if not search.getPath():
        return None
    parent = search.getPath().getNodeFromTail(1)
    points = parent.getChild(3).point
    return np.array([points[k].getValue() for k in range(points.getNum())])


def test_a_finding_is_shown_in_the_view(panel_of, hinges, gui, screenshot):
    panel = panel_of(hinges)
    texts = [text for text, _ in rows(panel)]
    signs = [text[0] for text in texts]
    assert signs == sorted(signs, key="✗!✓".index)
    assert "Errors" in panel.state.text()
    text, button = rows(panel)[0]
    assert "switch Compensate on" in text
    button.click()
    gui(0.3)
    (chosen,) = Gui.Selection.getSelectionEx()
    names = [name for name in hinges.BodyNames if name in text]
    assert len(names) == 2
    assert set(chosen.SubElementNames) == set(elements_of(hinges, names))
    screenshot("check-shown")
    scene = Gui.getDocument(hinges.Document).ActiveView.getSceneGraph()
    assert len(marks(scene)) == 1
    panel.reject()
    assert marks(scene) is None


def test_what_hides_a_finding_is_cut_away(panel_of, hinges, gui, screenshot, pixels):
    panel = panel_of(hinges)
    view = Gui.ActiveDocument.ActiveView
    view.viewIsometric()
    view.fitAll()
    whole = pixels()
    _, show = rows(panel)[0]
    panel.pointer.show(panel_findings(panel)[0])
    root = hinges.ViewObject.RootNode
    assert isinstance(root.getChild(0), coin.SoClipPlane)
    Gui.Selection.clearSelection()
    view.fitAll()
    cut = pixels()
    assert covered(cut) < 0.9 * covered(whole)
    show.click()
    screenshot("check-cut")
    panel.reject()
    assert not isinstance(root.getChild(0), coin.SoClipPlane)


def covered(pixels):
    """How many pixels are not white."""
    return sum(min(pixel) < 250 for pixel in pixels)


def panel_findings(panel):
    """All findings, the worst first."""
    found = [finding for step in panel.findings for finding in step]
    return sorted(found, key=lambda one: [ERROR, WARNING, NOTE].index(one.severity))


def buttons(panel, row):
    """Buttons of a finding."""
    return panel.list.itemAt(row).widget().findChildren(QtGui.QToolButton)


def test_a_cure_that_is_a_value_is_one_click(panel_of, hinges, gui, screenshot):
    panel = panel_of(hinges)
    assert "Errors" in panel.state.text()
    fix = next(b for b in buttons(panel, 0) if b.objectName() == "Fix")
    assert "switch Compensate on" in fix.toolTip()
    screenshot("check-fix")
    fix.click()
    assert hinges.Compensate
    wait(panel, gui)
    assert hinges.isValid()
    assert len(rows(panel)) > 5
    assert not any("switch Compensate on" in text for text, _ in rows(panel))
    asked = [b for b in panel.form.findChildren(QtGui.QPushButton) if "OpenSCAD" in b.text()]
    assert len([b for b in asked if b.isVisible()]) == 1
    assert hinges.Document.UndoNames[0] == "Fix"
    hinges.Document.undo()
    assert not hinges.Compensate


def test_marks_stay_on_the_body_whatever_the_view_shows(hinges, gui):
    scene = Gui.getDocument(hinges.Document).ActiveView.getSceneGraph()
    model = hinges.Proxy.model(hinges)
    index = hinges.BodyNames.index("unit01_secondary_right_upper")
    centre = model.bodies[index].shape.Solids[0].CenterOfMass
    pointer = Pointer(hinges)
    hinges.Placement.Base = App.Vector(100, 0, 0)
    for opening, state in ((None, 0.0), (0.0, 0.0), (0.0, 1.0)):
        hinges.Deployment = state
        hinges.Document.recompute()
        finding = Finding(
            severity=ERROR,
            code="wall",
            bodies=(hinges.BodyNames[index],),
            number=0,
            limit=0,
            message=phrase("x."),
            points=(tuple(centre),),
            opening=opening,
        )
        pointer.show(finding)
        (mark,) = marks(scene)
        solid = hinges.Shape.Solids[index]
        assert mark == pytest.approx(tuple(solid.CenterOfMass), abs=0.01)
    pointer.clear()
    assert marks(scene) is None


def test_a_unit_stands_for_its_bodies(hinges):
    assert len(elements_of(hinges, ["unit01"])) == hinges.BodyCount
    assert elements_of(hinges, ["unit02"]) == []


def test_only_the_worst_of_many_findings_are_shown(panel_of, coupon, gui):
    panel = panel_of(coupon)
    many = [
        Finding(
            severity=NOTE,
            code="x",
            message=phrase(
                "Note {k}.",
                k=k,
            ),
        )
        for k in range(50)
    ]
    many.append(
        Finding(
            severity=WARNING,
            code="x",
            message=phrase("A late warning."),
        )
    )

    def broken():
        raise RuntimeError("oh")

    panel.offer("More", "", lambda: many)
    panel.offer("Broken", "", broken)
    for button in panel.form.findChildren(QtGui.QPushButton):
        if button.text() in ("More", "Broken"):
            button.click()
    assert not panel.done
    wait(panel, gui)
    shown = [text for text, _ in rows(panel)]
    assert len(shown) == 40
    assert any("A late warning" in text for text in shown)
    assert any("RuntimeError: oh" in text for text in shown)
    assert panel.more.isVisible()


def test_a_print_is_checked_for_another_printer(panel_of, coupon, gui, screenshot):
    panel = panel_of(coupon)
    before = [text for text, _ in rows(panel)]
    assert not any("fuse" in text or "weld" in text for text in before)
    panel.form.findChild(QtGui.QDoubleSpinBox, "layer_height").setValue(0.9)
    panel.again.click()
    assert not panel.again.isEnabled()
    wait(panel, gui)
    after = [text for text, _ in rows(panel)]
    assert len(after) == len(before)
    assert any("Layers of 0.9 mm lay" in text and "weld" in text for text in after)
    assert panel.again.isEnabled()
    assert coupon.LayerHeight.Value == 0.2
    fit_view(isometric=True)
    screenshot("check-printer")


def test_openscad_is_asked_on_demand(panel_of, coupon, gui, monkeypatch):
    panel = panel_of(coupon)
    button = next(b for b in panel.form.findChildren(QtGui.QPushButton) if "OpenSCAD" in b.text())
    monkeypatch.setenv("OPENSCAD", "no-such-program")
    assert not openscad.installed()
    button.click()
    wait(panel, gui)
    assert not button.isEnabled()
    assert any("OpenSCAD was not found: install it" in text for text, _ in rows(panel))


def test_a_slicer_is_asked_on_demand_and_ends_with_the_panel(
    panel_of, coupon, gui, monkeypatch, tmp_path
):
    panel = panel_of(coupon)
    pid = tmp_path / "pid"
    program = tmp_path / "slicer"
    program.write_text(f"#!/bin/sh\necho $$ > {pid}\nexec sleep 60\n")
    program.chmod(0o755)
    monkeypatch.setenv("PRUSASLICER", str(program))
    button = next(b for b in panel.form.findChildren(QtGui.QPushButton) if "Slice" in b.text())
    button.click()
    end = time.monotonic() + 20
    while not (pid.is_file() and pid.read_text().strip()):
        assert time.monotonic() < end
        gui(0.1)
    os.kill(int(pid.read_text()), 0)  # it runs
    panel.reject()
    with pytest.raises(ProcessLookupError):  # noqa: PT012
        while time.monotonic() < end:
            os.kill(int(pid.read_text()), 0)
            gui(0.1)
