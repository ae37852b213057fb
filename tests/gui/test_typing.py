# SPDX-License-Identifier: LGPL-2.1-or-later
"""A number being typed into a panel counts when it is whole, and a slow preview comes back."""

import time

import FreeCAD as App
import FreeCADGui as Gui
import pytest
from PySide import QtCore, QtGui

from BistableWB import make
from BistableWB.taskpanels import panel_for


@pytest.fixture
def panel(gui):
    """The open panel of a TrianglePlacement."""
    doc = App.newDocument("Typed")
    curve = make.make_curve(doc)
    triangles = make.make_triangle_placement(doc, curve, edge_length=60)
    make.make_bistable_unit(doc, triangles)
    doc.recompute()
    opened = panel_for(triangles)
    Gui.Control.showDialog(opened)
    gui(0.3)
    yield opened
    opened.close()
    Gui.Control.closeDialog()
    gui(0.1)


def until(seen, gui, seconds=10):
    end = time.monotonic() + seconds
    while not seen() and time.monotonic() < end:
        gui(0.02)


def type_into(line, text):
    line.setFocus()
    line.selectAll()
    for letter in text:
        for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
            event = QtGui.QKeyEvent(kind, ord(letter), QtCore.Qt.NoModifier, letter)
            QtGui.QApplication.sendEvent(line, event)


def test_a_number_that_is_typed_counts_when_it_is_whole(panel, gui, monkeypatch):
    seen = []
    compute = type(panel)._compute_cheap
    monkeypatch.setattr(
        type(panel),
        "_compute_cheap",
        lambda self: seen.append(self.obj.EdgeLength.Value) or compute(self),
    )
    spin = panel.fields["EdgeLength"].widget
    type_into(spin.findChild(QtGui.QLineEdit), "5")
    gui(0.2)
    assert panel.obj.EdgeLength.Value == 60
    type_into(spin.findChild(QtGui.QLineEdit), "55")
    gui(0.2)
    assert seen == []
    until(lambda: seen, gui)
    assert set(seen) == {55.0}
    type_into(spin.findChild(QtGui.QLineEdit), "52")
    panel.fields["EdgeLength"].settle()  # what OK does
    assert panel.obj.EdgeLength.Value == 52


def test_steps_of_a_spin_box_count_at_once(panel, gui):
    spin = panel.fields["EdgeLength"].widget
    spin.stepUp()
    assert panel.obj.EdgeLength.Value == 61


def test_a_preview_that_was_slow_comes_back(panel, gui, monkeypatch):
    compute, delays, done = type(panel)._compute_cheap, [0.5], []

    def slow(self):
        time.sleep(delays[0])
        done.append(self.obj.EdgeLength.Value)
        compute(self)

    monkeypatch.setattr(type(panel), "_compute_cheap", slow)
    spin = panel.fields["EdgeLength"].widget
    spin.stepUp()
    until(lambda: done, gui)
    assert done == [61]
    assert "slow" in panel.message.text()
    delays[0] = 0.0
    spin.stepUp()
    spin.stepUp()
    gui(0.3)
    assert done == [61]  # it waits for a pause
    until(lambda: len(done) > 1, gui)
    assert done == [61, 63]
    spin.stepUp()
    until(lambda: len(done) > 2, gui)
    assert done == [61, 63, 64]
