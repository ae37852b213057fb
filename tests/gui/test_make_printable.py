# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make it printable in the window: what it changes and why, preview, OK, undo, macro, bad input."""

import time

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
from PySide import QtCore, QtGui

from BistableWB import make
from BistableWB.objects import type_of
from BistableWB.origami.errors import phrase
from BistableWB.origami.fit.printable import Answer

_kept = {}  # what was found for the example arch: searched once


def opened(gui, monkeypatch):
    """The panel that the command opens; its search is left to the test."""
    from BistableWB.taskpanels.make_printable import MakePrintablePanel

    panels = []
    monkeypatch.setattr(MakePrintablePanel, "start", lambda panel: panels.append(panel))
    Gui.runCommand("Bistable_MakePrintable")
    gui(0.1)
    monkeypatch.undo()
    return panels[0]


def search(panel, gui):
    panel.start()
    end = time.monotonic() + 300
    while panel._search:
        assert time.monotonic() < end
        gui(0.1)


def found(panel, gui):
    """The panel with what was found for its curve, the example arch."""
    if "answer" not in _kept:
        search(panel, gui)
        _kept["answer"] = Answer(panel.proposal.found, [])
    else:
        from BistableWB import fitting

        panel.request = fitting.request_of(panel.chain)
        panel.show_answer(_kept["answer"])
    return panel


def button(kind):
    boxes = Gui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
    return next(b for b in boxes if b.isVisible() and b.button(kind)).button(kind)


@pytest.fixture
def arch(gui):
    doc = App.newDocument("Arch")
    doc.UndoMode = 1
    make.make_curve(doc)
    doc.recompute()
    return doc


@pytest.fixture(autouse=True)
def closed(gui):
    yield
    if Gui.Control.activeDialog():
        button(QtGui.QDialogButtonBox.Cancel).click()
        gui(0.1)


def test_it_says_what_it_changes_and_why_and_ok_is_one_step(
    arch, gui, monkeypatch, screenshot, headless
):
    recorded, do_command = [], Gui.doCommand
    panel = found(opened(gui, monkeypatch), gui)
    text = panel.table.text()
    assert "Edge length" in text
    assert "units along" in text
    assert "snap margin" in panel.headline.text()
    assert panel._shown is not None
    screenshot("make-printable")
    assert [o.Name for o in arch.Objects] == ["Curve"]
    monkeypatch.setattr(Gui, "doCommand", lambda line: (recorded.append(line), do_command(line)))
    button(QtGui.QDialogButtonBox.Ok).click()
    gui(0.2)
    assert not Gui.Control.activeDialog()
    assert arch.UndoNames == ["Make it printable"]
    promised = panel.proposal.found.margins
    assert arch.HingeSet.SnapMargins == pytest.approx(promised.tolist(), rel=0.01)
    assert arch.TrianglePlacement.EndGap.Value < 0.01
    told = "\n".join(recorded)
    arch.undo()
    gui()
    assert [o.Name for o in arch.Objects] == ["Curve"]
    replayed(headless, told, len(promised))


def replayed(headless, lines, count):
    code = (
        "import FreeCAD as App, BistableWB\nfrom BistableWB import make\n"
        "doc = App.newDocument('Replay')\nmake.make_curve(doc)\ndoc.recompute()\n"
        f"{lines}\nprint('made', doc.TrianglePlacement.Count, len(doc.HingeSet.SnapMargins), "
        "doc.HingeSet.isValid(), flush=True)"
    )
    (line,) = [line for line in headless(code) if line.startswith("made ")]
    assert line == f"made {count} {count} True"


def test_a_selected_sketch_gets_its_curve_in_the_same_step(gui, monkeypatch, arch):
    drawn = arch.addObject("Part::Feature", "Drawn")
    drawn.Shape = Part.Wire(arch.Curve.Shape.Edges)
    arch.removeObject("Curve")
    arch.clearUndos()
    Gui.Selection.addSelection(drawn)
    panel = found(opened(gui, monkeypatch), gui)
    assert [o.Name for o in arch.Objects] == ["Drawn"]
    assert panel.accept()
    Gui.Control.closeDialog()
    types = [type_of(o).partition("::")[2] for o in arch.Objects[1:]]
    assert types == ["Curve", "TrianglePlacement", "BistableUnit", "HingeSet"]
    assert arch.UndoNames == ["Make it printable"]
    assert all(o.isValid() for o in arch.Objects)


def test_cancel_stops_the_search_and_changes_nothing(arch, gui, monkeypatch):
    panel = opened(gui, monkeypatch)
    scene = Gui.ActiveDocument.ActiveView.getSceneGraph()
    children = scene.getNumChildren()
    panel.start()
    going_on = panel._search
    key = QtGui.QKeyEvent(QtCore.QEvent.KeyPress, QtCore.Qt.Key_Escape, QtCore.Qt.NoModifier)
    QtGui.QApplication.sendEvent(panel.form, key)
    gui(0.1)
    if Gui.Control.activeDialog():
        button(QtGui.QDialogButtonBox.Cancel).click()
        gui(0.1)
    assert going_on._stopped
    assert not Gui.Control.activeDialog()
    assert [o.Name for o in arch.Objects] == ["Curve"]
    assert scene.getNumChildren() == children
    assert not arch.UndoNames


def test_what_stands_in_the_way_is_said(arch, gui, monkeypatch):
    panel = opened(gui, monkeypatch)
    assert not panel.accept()
    panel.show_answer(Answer(None, [], phrase("a longer curve would do")))
    assert "No tube can be made" in panel.headline.text()
    assert "a longer curve would do" in panel.headline.text()
    assert not panel.accept()
    panel.requirements.fields["margin"].setValue(0)
    panel.start()
    assert "above 0" in panel.requirements.errors["Margin"].text()


def test_other_designs_can_be_compared(arch, gui, monkeypatch):
    from BistableWB.taskpanels.auto_fit import AutoFitPanel

    panel = opened(gui, monkeypatch)
    started = []
    monkeypatch.setattr(AutoFitPanel, "start", lambda panel: started.append(panel))
    panel.others.click()
    gui(0.2)
    assert started[0].source is arch.Curve
    assert Gui.Control.activeDialog()
