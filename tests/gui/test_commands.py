# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every command in the real window: what it makes, undo, macros."""

import time

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
from PySide import QtGui

from BistableWB.commands.base import fit_view
from BistableWB.objects import type_of

CURVE, TRIANGLES, UNIT = (
    "Bistable::Curve",
    "Bistable::TrianglePlacement",
    "Bistable::BistableUnit",
)


def run(name):
    Gui.runCommand(f"Bistable_{name}")


def types():
    return [type_of(obj) for obj in App.ActiveDocument.Objects]


def is_active(name):
    from BistableWB.commands import COMMANDS

    return next(c for c in COMMANDS if c.name == f"Bistable_{name}").IsActive()


def assert_valid(doc):
    for obj in doc.Objects:
        assert obj.isValid(), f"{obj.Name}: {obj.getStatusString()}"


def test_new_tube_makes_the_whole_chain_in_one_step(gui, screenshot):
    run("NewTube")
    doc = App.ActiveDocument
    assert types() == [CURVE, TRIANGLES, UNIT]
    assert_valid(doc)
    assert len(doc.BistableUnit.Shape.Faces) == 12 * doc.TrianglePlacement.Count > 100
    assert doc.UndoNames == ["New tube"]
    screenshot("new-tube")


def test_undo_and_redo_of_new_tube(gui):
    run("NewTube")
    doc = App.ActiveDocument
    doc.undo()
    gui()
    assert doc.Objects == []
    doc.redo()
    doc.recompute()
    gui()
    assert types() == [CURVE, TRIANGLES, UNIT]
    assert_valid(doc)


def test_new_tube_joins_an_open_document(gui):
    doc = App.newDocument("Mine")
    doc.addObject("Part::Box", "Box")
    run("NewTube")
    assert App.ActiveDocument is doc
    assert len(doc.Objects) == 4


def test_the_steps_one_by_one_follow_each_other(gui):
    run("Curve")
    assert types() == [CURVE]
    run("TrianglePlacement")
    run("Units")
    doc = App.ActiveDocument
    assert types() == [CURVE, TRIANGLES, UNIT]
    assert doc.TrianglePlacement.Curve is doc.Curve
    assert doc.BistableUnit.Triangles is doc.TrianglePlacement
    assert_valid(doc)
    assert doc.UndoNames == ["Bistable units", "Triangle placement", "Curve"]


def test_curve_on_sphere_carries_a_tube(gui, screenshot):
    run("CurveOnSphere")
    run("Units")
    doc = App.ActiveDocument
    assert types() == [CURVE, TRIANGLES, UNIT]
    assert doc.Curve.Kind == "Sphere"
    assert doc.BistableUnit.RatioRule == "Adaptive"
    assert_valid(doc)
    assert doc.BistableUnit.IsometryError < 1e-9
    fit_view(isometric=True)
    screenshot("curve-on-sphere")


def test_units_without_triangles_are_one_unit(gui, screenshot):
    run("Units")
    doc = App.ActiveDocument
    assert types() == [UNIT]
    assert len(doc.BistableUnit.Shape.Faces) == 12
    assert_valid(doc)
    fit_view(isometric=True)
    screenshot("one-unit")


def test_units_on_units_make_no_lonely_unit(gui):
    run("NewTube")
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(App.ActiveDocument.BistableUnit)
    run("Units")
    second = App.ActiveDocument.Objects[-1]
    assert second.Triangles is App.ActiveDocument.TrianglePlacement


def arc_in_document():
    doc = App.newDocument("Mine")
    doc.addObject("Part::Box", "Box")
    arc = doc.addObject("Part::Feature", "Arc")
    arc.Shape = Part.makeCircle(150, App.Vector(), App.Vector(0, 0, 1), 0, 120)
    doc.recompute()
    return doc, arc


@pytest.mark.parametrize("element", ["", "Edge1"])
def test_curve_follows_the_selection(gui, element):
    doc, arc = arc_in_document()
    Gui.Selection.addSelection(doc.Name, arc.Name, element)
    run("Curve")
    assert doc.Curve.Source == (arc, [element])
    assert doc.Curve.Length.Value == pytest.approx(arc.Shape.Length, rel=1e-6)


def test_triangles_on_a_selected_edge_make_the_curve_too(gui):
    doc, arc = arc_in_document()
    assert not is_active("TrianglePlacement")
    Gui.Selection.addSelection(doc.Name, arc.Name, "Edge1")
    assert is_active("TrianglePlacement")
    run("TrianglePlacement")
    assert types()[2:] == [CURVE, TRIANGLES]
    assert doc.UndoNames == ["Triangle placement"]
    assert_valid(doc)


def test_curve_on_the_selected_sphere(gui):
    doc, arc = arc_in_document()
    ball = doc.addObject("Part::Sphere", "Ball")
    ball.Radius = 155
    doc.recompute()
    Gui.Selection.addSelection(doc.Name, arc.Name, "Edge1")
    Gui.Selection.addSelection(doc.Name, ball.Name)
    run("CurveOnSphere")
    assert doc.Curve.SphereRadius.Value == 155
    assert doc.Curve.Source[0] is arc
    assert_valid(doc)


def test_a_failing_line_leaves_the_document_as_it_was(gui):
    from BistableWB.commands.base import Script

    doc = App.newDocument("Mine")
    with Script("Try") as script:
        script.add("curve = make.make_curve(doc)")
        script.add("raise ValueError('no')")
    assert doc.Objects == []
    assert doc.UndoCount == 0


def test_recorded_lines_replay_without_a_window(gui, monkeypatch, headless):
    recorded = []
    do_command = Gui.doCommand

    def record(line):
        recorded.append(line)
        do_command(line)

    monkeypatch.setattr(Gui, "doCommand", record)
    run("CurveOnSphere")
    run("TrianglePlacement")
    run("Units")
    expected = {obj.Name: obj.Shape.Length for obj in App.ActiveDocument.Objects}
    lines = headless(
        "import FreeCAD as App, BistableWB\n"
        + "\n".join(recorded)
        + "\nprint({o.Name: o.Shape.Length for o in doc.Objects}, flush=True)\n"
    )
    (line,) = [line for line in lines if line.startswith("{'Curve'")]
    assert eval(line) == pytest.approx(expected)


@pytest.mark.parametrize("number", [0, 1, 2])
def test_examples_open_whole(gui, screenshot, number):
    from BistableWB.commands.files import examples, make_example

    path = examples()[number]
    make_example(path)
    assert types()[:3] == [CURVE, TRIANGLES, UNIT]
    assert_valid(App.ActiveDocument)
    screenshot(f"example-{path.stem}")


def test_open_example_offers_the_examples_by_name(gui):
    from BistableWB.commands import COMMANDS

    run("OpenExample")
    command = next(c for c in COMMANDS if c.name == "Bistable_OpenExample")
    names = [action.text() for action in command.menu.actions()]
    assert "Plane arch" in names
    assert len(names) >= 3
    command.menu.actions()[names.index("Plane arch")].trigger()
    command.menu.close()
    assert types()[:3] == [CURVE, TRIANGLES, UNIT]


def test_help_opens_a_page_with_text(gui, screenshot):
    run("Help")
    gui(0.2)
    window = Gui.getMainWindow().findChild(QtGui.QDialog, "BistableHelp")
    assert window.isVisible()
    assert not window.isModal()
    assert "first tube" in window.findChild(QtGui.QTextBrowser).toPlainText()
    screenshot("help")
    window.close()


def test_asking_whether_commands_are_active_is_cheap(gui):
    from BistableWB.commands import COMMANDS

    run("NewTube")
    App.ActiveDocument.Curve.Points = [App.Vector(30 * i, 60 * (i % 2), 0) for i in range(12)]
    App.ActiveDocument.recompute()
    Gui.Selection.addSelection(App.ActiveDocument.BistableUnit)
    start = time.perf_counter()
    for _ in range(100):
        for command in COMMANDS:
            command.IsActive()
    assert (time.perf_counter() - start) / 100 < 0.001


def test_messages_of_repair(gui, capfd):
    run("NewTube")
    run("Repair")
    assert "Nothing to repair" in capfd.readouterr().out
