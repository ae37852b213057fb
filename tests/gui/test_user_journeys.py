# SPDX-License-Identifier: LGPL-2.1-or-later
"""What users do in the window that no other test does."""

from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtGui

from BistableWB import make


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
