# SPDX-License-Identifier: LGPL-2.1-or-later
"""The calibration plate in the window: one command, and two questions whose answers are kept."""

import FreeCAD as App
import FreeCADGui as Gui
import pytest
from PySide import QtGui

from BistableWB import settings
from BistableWB.objects import type_of


@pytest.fixture
def answers():
    """Preferences as they were, afterwards."""
    group = settings.group()
    before = settings.number("GapLength"), settings.calibrated_clearance(), settings.air_layers()
    yield settings
    group.SetFloat("GapLength", before[0])
    group.SetFloat(settings.CLEARANCE, before[1])
    group.SetInt(settings.AIR_LAYERS, before[2])


def test_one_command_and_two_answers(gui, screenshot, answers):
    Gui.runCommand("Bistable_Calibration")
    doc = App.ActiveDocument
    (plate,) = doc.Objects
    assert type_of(plate) == "Bistable::CalibrationPlate"
    assert plate.isValid()
    assert doc.UndoNames == ["Calibration plate"]
    plate.ViewObject.Proxy.doubleClicked(plate.ViewObject)
    gui(0.3)
    form = Gui.getMainWindow().findChild(QtGui.QWidget, "BistablePanel")
    tightest, apart = (
        form.findChild(QtGui.QComboBox, name) for name in ("TightestThatTurns", "AirLayers")
    )
    assert tightest.count() == 1 + len(plate.Clearances)
    tightest.setCurrentIndex(3)
    apart.setCurrentIndex(1)
    screenshot("calibration")
    box = next(
        b for b in Gui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
        if b.isVisible() and b.button(QtGui.QDialogButtonBox.Ok)
    )  # fmt: skip
    box.button(QtGui.QDialogButtonBox.Ok).click()
    gui(0.3)
    assert settings.calibrated_clearance() == 0.3
    assert settings.air_layers() == 1
    Gui.runCommand("Bistable_HingeCoupon")
    assert doc.Objects[-1].GapLength.Value == pytest.approx(0.3)
