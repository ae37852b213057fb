# SPDX-License-Identifier: LGPL-2.1-or-later
"""What users do in the window that no other test does."""

from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import pytest
from PySide import QtGui

from BistableWB import make
from BistableWB.commands.hinges import chosen_units


def test_a_label_with_odd_characters_is_no_path(gui, monkeypatch, tmp_path):
    doc = App.newDocument("Odd")
    unit = make.make_bistable_unit(doc, theta=45, edge_length=60)
    unit.Label = 'Bögen 1/2 "a" <b>'
    doc.recompute()
    asked = []

    def answer(parent, title, start, filters):
        asked.append(Path(start))
        return str(tmp_path / asked[-1].name), "OBJ (*.obj)"

    monkeypatch.setattr(QtGui.QFileDialog, "getSaveFileName", answer)
    Gui.runCommand("Bistable_ExportPrint")
    assert asked[0].name == "Odd-Bögen 1-2 -a- -b-"
    assert (tmp_path / f"{asked[0].name}.obj").stat().st_size > 100


@pytest.mark.parametrize("part", ["Curve", "TrianglePlacement", "BistableUnit"])
def test_hinges_are_made_from_any_part_of_a_tube(gui, part):
    Gui.runCommand("Bistable_NewTube")
    doc = App.ActiveDocument
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(doc.getObject(part))
    assert chosen_units() == doc.BistableUnit
    other = make.make_curve(doc, name="Other")
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(other)
    assert chosen_units() is None  # the start of another tube
