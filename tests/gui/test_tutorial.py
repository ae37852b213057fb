# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tutorial "first tube in five minutes": its steps work, and its pictures are made here."""

import re
import time

import FreeCAD as App
import FreeCADGui as Gui
from PySide import QtCore, QtGui

from BistableWB import RESOURCES
from BistableWB.commands import COMMANDS

PAGE = RESOURCES / "help" / "first-tube.md"


def steps():
    """The text of each numbered step."""
    text = PAGE.read_text(encoding="utf-8")
    return re.findall(r"^\d\. (.*?)(?=^\d\. |^\S)", text, re.MULTILINE | re.DOTALL)


def command_of(step):
    """The command that a step names first."""
    name = re.search(r"\*\*(.+?)\*\*", step).group(1)
    return next((command.name for command in COMMANDS if command.text == name), None)


def press(button, gui):
    boxes = Gui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
    next(b for b in boxes if b.isVisible() and b.button(button)).button(button).click()
    gui(0.3)


def test_the_page_has_six_steps_and_all_its_pictures():
    assert [command_of(step) for step in steps()] == [
        "Bistable_NewTube",
        "Bistable_Deploy",
        None,  # a double click
        "Bistable_HingeSet",
        "Bistable_Check",
        "Bistable_ExportPrint",
    ]
    pictures = re.findall(r"\]\((.+?)\)", PAGE.read_text(encoding="utf-8"))
    assert len(pictures) == 5
    for picture in pictures:
        assert not QtGui.QImage(str(PAGE.parent / picture)).isNull(), picture


def test_every_step_does_what_the_page_says(gui, screenshot, monkeypatch, tmp_path):
    names = [command_of(step) for step in steps()]
    Gui.runCommand(names[0])
    doc = App.ActiveDocument
    screenshot("first-tube-1")

    Gui.runCommand(names[1])
    gui(0.3)
    window = Gui.getMainWindow()
    window.findChild(QtGui.QSlider, "Opening").setValue(500)
    screenshot("first-tube-2")
    press(QtGui.QDialogButtonBox.Cancel, gui)
    assert doc.BistableUnit.Deployment == 1

    doc.TrianglePlacement.ViewObject.Proxy.doubleClicked(doc.TrianglePlacement.ViewObject)
    gui(0.3)
    count = doc.TrianglePlacement.Count
    field = window.findChild(QtGui.QAbstractSpinBox, "EdgeLength")
    field.findChild(QtGui.QLineEdit).setText("90 mm")
    gui(0.5)
    assert doc.TrianglePlacement.Count < count
    screenshot("first-tube-3")
    press(QtGui.QDialogButtonBox.Ok, gui)

    Gui.runCommand(names[3])
    gui(0.3)
    hinges = doc.Objects[-1]
    assert hinges.isValid(), hinges.getStatusString()
    assert hinges.BodyCount == 14 * doc.TrianglePlacement.Count + 1
    screenshot("first-tube-4")

    Gui.runCommand(names[4])
    form = window.findChild(QtGui.QWidget, "BistableCheck")
    wait(gui, lambda: form.findChild(QtGui.QProgressBar).isHidden())
    screenshot("first-tube-5")
    press(QtGui.QDialogButtonBox.Close, gui)

    target = str(tmp_path / "tube.3mf")
    monkeypatch.setattr(QtGui.QFileDialog, "getSaveFileName", lambda *_: (target, "3MF (*.3mf)"))
    Gui.runCommand(names[5])
    assert QtCore.QFileInfo(target).size() > 10000


def wait(gui, ready, seconds=240):
    end = time.monotonic() + seconds
    while not ready():
        assert time.monotonic() < end
        gui(0.2)
