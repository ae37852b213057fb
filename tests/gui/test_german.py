# SPDX-License-Identifier: LGPL-2.1-or-later
"""German: complete, up to date, and what the window shows."""

import importlib.util
import re
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import pytest
from PySide import QtCore, QtGui

from BistableWB import RESOURCES, TRANSLATIONS, make
from BistableWB.commands import COMMANDS, files


@pytest.fixture(scope="module")
def update():
    path = TRANSLATIONS / "update.py"
    spec = importlib.util.spec_from_file_location("bistable_translations", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def german(gui):
    if not hasattr(Gui, "setLocale"):
        pytest.skip("this FreeCAD cannot change its language from Python")
    Gui.setLocale("German")
    gui(0.3)
    yield gui
    Gui.setLocale("English")
    gui(0.3)


def test_every_text_is_translated(update):
    """After a new text: resources/translations/update.py, then fill in the .ts, then it again."""
    known = update.read(TRANSLATIONS / "Bistable_de.ts")
    assert update.messages() - set(known) == set()


def test_the_compiled_file_says_what_the_source_says(update):
    translator = QtCore.QTranslator()
    assert translator.load(str(TRANSLATIONS / "Bistable_de.qm"))
    known = update.read(TRANSLATIONS / "Bistable_de.ts")
    different = {key for key, german in known.items() if translator.translate(*key) != german}
    assert different == set()


def test_placeholders_survive_translation(update):
    for (_, text), german in update.read(TRANSLATIONS / "Bistable_de.ts").items():
        assert text.count("{") == german.count("{"), text


def outline(path):
    """What a page is made of: headings, steps, tables, pictures, links."""
    text = path.read_text(encoding="utf-8")
    marks = re.findall(r"^#+|^\d\.|^\||!\[|\]\([\w-]+\.md\)", text, re.MULTILINE)
    return marks, sorted(Path(p).name for p in re.findall(r"\]\((.+?)\)", text))


@pytest.mark.parametrize("name", ["index.md", "first-tube.md"])
def test_a_german_page_has_all_that_the_english_one_has(update, name):
    english, german = RESOURCES / "help" / name, RESOURCES / "help" / "de" / name
    assert outline(german) == outline(english)
    text = german.read_text(encoding="utf-8")
    for picture in re.findall(r"\]\((.+?)\)", text):
        assert (german.parent / picture).is_file()
    known = update.read(TRANSLATIONS / "Bistable_de.ts")
    named = {known.get((command.name, command.text)) for command in COMMANDS}
    objects = {"Curve", "TrianglePlacement"}  # which bear these names in the tree
    bold = re.compile(r"\*\*(\w[^*\[\n]*)\*\*")
    written = set(bold.findall(english.read_text(encoding="utf-8"))) - objects
    for command in COMMANDS:
        if command.text in written:
            assert f"**{known[command.name, command.text]}**" in text
    assert set(bold.findall(text)) <= named | objects


def test_the_window_speaks_german(german, screenshot):
    gui = german
    Gui.activateWorkbench("BistableWorkbench")
    assert App.Qt.translate("Bistable_NewTube", "New tube") == "Neuer Schlauch"
    assert files.help_page() == RESOURCES / "help" / "de" / "index.md"
    doc = App.newDocument("Deutsch")
    curve = make.make_curve(doc)
    triangles = make.make_triangle_placement(doc, curve)
    doc.recompute()
    Gui.ActiveDocument.ActiveView.fitAll()
    triangles.ViewObject.Proxy.doubleClicked(triangles.ViewObject)
    gui(0.3)
    form = Gui.getMainWindow().findChild(QtGui.QWidget, "BistablePanel")
    texts = [label.text() for label in form.findChildren(QtGui.QLabel)]
    assert "Kantenlänge" in texts
    screenshot("german")
    boxes = Gui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
    next(b for b in boxes if b.isVisible()).button(QtGui.QDialogButtonBox.Cancel).click()
    gui(0.2)
