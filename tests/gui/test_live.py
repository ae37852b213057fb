# SPDX-License-Identifier: LGPL-2.1-or-later
"""Solids that follow beside the window: it goes on, Esc stops them, and undo finds them again."""

import contextlib
import threading
import time

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
import Sketcher
from PySide import QtCore, QtGui

from BistableWB import make
from BistableWB.objects import later, thick_model
from BistableWB.origami import memory
from BistableWB.origami.progress import Cancelled
from BistableWB.taskpanels import panel_for

STALL = 0.3  # s


class Stalls:
    """Longest time between two ticks of a timer in the window."""

    def __init__(self):
        self.longest, self._last = 0.0, time.monotonic()
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._tick)
        self._timer.start(10)

    def _tick(self):
        now = time.monotonic()
        self.longest, self._last = max(self.longest, now - self._last), now

    def stop(self):
        self._timer.stop()
        return self.longest


@contextlib.contextmanager
def by_hand(monkeypatch):
    """What is recomputed within it is as if a user had done it in the window."""
    with monkeypatch.context() as patch:
        patch.setattr(later, "_python_waits", lambda: False)
        yield


@contextlib.contextmanager
def being_made(monkeypatch):
    """Solids ordered within it are not ready before its end, however fast the machine is."""
    order, ended = thick_model.Order.made, threading.Event()

    def made(self, progress, *args):
        assert ended.wait(60)
        progress.step()
        return order(self, progress, *args)

    with monkeypatch.context() as patch:
        patch.setattr(thick_model.Order, "made", made)
        yield
        ended.set()


@pytest.fixture
def hinges(gui):
    """Four hinged units."""
    doc = App.newDocument("Short")
    curve = make.make_curve(doc, points=[(0, 0, 0), (40, 80, 0), (110, 80, 0)])
    triangles = make.make_triangle_placement(doc, curve, edge_length=60)
    unit = make.make_bistable_unit(doc, triangles)
    made = make.make_hinge_set(doc, unit)
    doc.UndoMode = 1
    doc.recompute()
    gui(0.3)
    assert made.isValid()
    assert made.UpToDate
    return made


def edit(doc, obj, name, value, title="Edit"):
    doc.openTransaction(title)
    setattr(obj, name, value)
    doc.commitTransaction()
    doc.recompute()


def finish(gui, seconds=120):
    end = time.monotonic() + seconds
    while later.runner.is_busy():
        assert time.monotonic() < end
        gui(0.02)
    gui(0.1)


def button(name):
    return Gui.getMainWindow().findChild(QtGui.QPushButton, name)


def press(key):
    for kind in (QtCore.QEvent.KeyPress, QtCore.QEvent.KeyRelease):
        event = QtGui.QKeyEvent(kind, key, QtCore.Qt.NoModifier)
        QtGui.QApplication.sendEvent(Gui.getMainWindow(), event)


def test_an_edit_by_hand_leaves_the_window_alive(hinges, gui, monkeypatch, screenshot):
    doc, before = hinges.Document, hinges.PrintSize.x
    memory.forget()
    stalls = Stalls()
    start = time.monotonic()
    with by_hand(monkeypatch):
        edit(doc, doc.TrianglePlacement, "EdgeLength", 65)
        assert not hinges.UpToDate
        assert hinges.isValid()
        assert hinges.PrintSize.x == before  # the old ones stay, and are grey
        assert hinges.ViewObject.Proxy.is_stale(hinges)
        gui(0.05)
        screenshot("live-stale")
        finish(gui)
    took = time.monotonic() - start
    print(f"edit: {took:.1f} s, longest stall {stalls.stop():.2f} s")
    assert hinges.UpToDate
    assert hinges.PrintSize.x == pytest.approx(before + 5, abs=1.5)


def drawn_arc(doc):
    """A sketch of an arc whose radius is a dimension."""
    sketch = doc.addObject("Sketcher::SketchObject", "Sketch")
    circle = Part.Circle(App.Vector(), App.Vector(0, 0, 1), 110)
    sketch.addGeometry(Part.ArcOfCircle(circle, 0.3, 1.9), False)
    sketch.addConstraint(Sketcher.Constraint("Coincident", 0, 3, -1, 1))
    sketch.addConstraint(Sketcher.Constraint("Radius", 0, 110.0))
    return sketch


def by_sketch(doc):
    doc.Sketch.setDatum(1, App.Units.Quantity("115 mm"))


def by_cell(doc):
    doc.Spreadsheet.set("A1", "62 mm")


def by_property_editor(doc):
    Gui.doCommand(f"App.getDocument('{doc.Name}').BistableUnit.HeightRatio = 2.6")


@pytest.mark.parametrize("change", [by_sketch, by_cell, by_property_editor])
def test_a_sketch_a_cell_or_a_property_leaves_solids_to_follow(change, gui, monkeypatch):
    doc = App.newDocument("Driven")
    cells = doc.addObject("Spreadsheet::Sheet", "Spreadsheet")
    cells.set("A1", "60 mm")
    doc.recompute()
    curve = make.make_curve(doc, source=drawn_arc(doc))
    triangles = make.make_triangle_placement(doc, curve)
    triangles.setExpression("EdgeLength", "Spreadsheet.A1")
    made = make.make_hinge_set(doc, make.make_bistable_unit(doc, triangles))
    doc.recompute()
    assert made.UpToDate, made.getStatusString()
    before, old = made.MadeFrom, made.Shape.Volume
    with by_hand(monkeypatch), being_made(monkeypatch):
        change(doc)
        doc.recompute()
        assert later.runner.is_busy()
        assert not made.UpToDate
        gui(0.05)  # the window goes on
        assert made.Shape.Volume == pytest.approx(old)
        press(QtCore.Qt.Key_Escape)
    finish(gui)
    assert not made.UpToDate
    assert made.MadeFrom == before
    with by_hand(monkeypatch):
        later.runner.make_stale()
        finish(gui)
    assert made.UpToDate
    assert made.MadeFrom != before


def test_python_that_waits_gets_its_solids(hinges):
    doc = hinges.Document
    doc.TrianglePlacement.EdgeLength = 62
    doc.recompute()
    assert hinges.UpToDate
    assert not later.runner.is_busy()


def test_esc_keeps_the_old_solids_and_enter_makes_them(hinges, gui, monkeypatch):
    doc, before = hinges.Document, hinges.MadeFrom
    with by_hand(monkeypatch):
        with being_made(monkeypatch):
            edit(doc, doc.TrianglePlacement, "Gamma", 22.5)
            gui(0.1)
            press(QtCore.Qt.Key_Escape)
        finish(gui)
        assert not hinges.UpToDate
        assert hinges.MadeFrom == before
        assert button("BistableMake").isVisible()
        view = Gui.ActiveDocument.ActiveView.graphicsView()
        event = QtGui.QKeyEvent(QtCore.QEvent.KeyPress, QtCore.Qt.Key_Return, QtCore.Qt.NoModifier)
        QtGui.QApplication.sendEvent(view, event)
        gui(0.1)
        finish(gui)
    assert hinges.UpToDate
    assert hinges.MadeFrom != before
    assert not button("BistableMake").isVisible()


def test_on_demand_makes_nothing_until_it_is_asked(hinges, gui, monkeypatch):
    doc, made = hinges.Document, []
    order = thick_model.Order.made
    monkeypatch.setattr(thick_model.Order, "made", lambda *args: made.append(1) or order(*args))
    hinges.Update = "OnDemand"
    with by_hand(monkeypatch):
        edit(doc, doc.TrianglePlacement, "Gamma", 23.5)
        gui(0.3)
        assert not made
        assert not hinges.UpToDate
        assert doc.BistableUnit.isValid()  # the thin tube follows
        button("BistableMake").click()
        finish(gui)
    assert made == [1]
    assert hinges.UpToDate


def test_undo_brings_back_the_solids_that_belong_to_it(hinges, gui, monkeypatch):
    doc, before = hinges.Document, hinges.MadeFrom
    with by_hand(monkeypatch):
        edit(doc, doc.TrianglePlacement, "Gamma", 24.5)
        finish(gui)
        after = hinges.MadeFrom
        assert after != before
        doc.undo()
        gui(0.2)
        finish(gui)
        assert doc.TrianglePlacement.Gamma.Value == 20
        assert hinges.MadeFrom == before
        assert hinges.UpToDate
        doc.redo()
        gui(0.2)
        finish(gui)
        assert hinges.MadeFrom == after
        assert hinges.UpToDate


@pytest.mark.provokes_errors
def test_what_is_refused_aside_is_said_by_the_object(hinges, gui, monkeypatch):
    doc = hinges.Document
    with by_hand(monkeypatch):
        edit(doc, hinges, "Segmentations", 4)
        finish(gui)
        assert not hinges.isValid()
        assert "odd number" in hinges.getStatusString()
        edit(doc, hinges, "Segmentations", 5)
        finish(gui)
    assert hinges.isValid()
    assert hinges.UpToDate


def test_closing_the_document_ends_what_is_made_for_it(hinges, gui, monkeypatch):
    doc = hinges.Document
    with by_hand(monkeypatch):
        edit(doc, doc.TrianglePlacement, "Gamma", 21.5)
        App.closeDocument(doc.Name)
        gui(0.2)
        finish(gui)
    assert not later.runner.is_busy()


def test_esc_while_python_waits_is_told_to_it(hinges, gui, monkeypatch):
    doc = hinges.Document
    doc.TrianglePlacement.Gamma = 25.5
    QtCore.QTimer.singleShot(200, lambda: press(QtCore.Qt.Key_Escape))
    slow = thick_model.Order.made

    def slower(self, progress, saved=()):
        for _ in range(100):
            progress.step("", 0.1)
            time.sleep(0.02)
        return slow(self, progress, saved)

    monkeypatch.setattr(thick_model.Order, "made", slower)
    with pytest.raises(Cancelled):
        make.make_solids(hinges)


def test_ok_leaves_the_solids_above_to_follow(hinges, gui):
    doc, before = hinges.Document, hinges.MadeFrom
    opened = panel_for(doc.TrianglePlacement)
    Gui.Control.showDialog(opened)
    gui(0.2)
    doc.TrianglePlacement.Gamma = 26.5
    stalls = Stalls()
    assert opened.accept()
    Gui.Control.closeDialog()
    gui(0.05)
    finish(gui)
    print(f"OK: longest stall {stalls.stop():.2f} s")
    assert hinges.UpToDate
    assert hinges.MadeFrom != before


def test_pillars_of_an_export_do_not_freeze_the_window(hinges, gui, monkeypatch):
    doc = hinges.Document
    with by_hand(monkeypatch):
        edit(doc, doc.TrianglePlacement, "Gamma", 24)
        end = time.monotonic() + 60
        while not hinges.UpToDate and time.monotonic() < end:
            gui(0.05)
    ticks, timer = [], QtCore.QTimer()
    timer.timeout.connect(lambda: ticks.append(time.monotonic()))
    timer.start(10)
    began = time.monotonic()
    bodies = hinges.Proxy.export_bodies(hinges)
    took = time.monotonic() - began
    timer.stop()
    assert ticks or took < 2 * STALL  # the window went on
    assert bodies[-1][0] == "pillars"
    finish(gui)
    assert len(hinges.SnapMargins) == doc.TrianglePlacement.Count
