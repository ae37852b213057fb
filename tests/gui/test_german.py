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
from BistableWB.commands import COMMANDS, files, output
from BistableWB.taskpanels import sentences
from BistableWB.taskpanels.check import CheckPanel


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
        fields, same = (sorted(re.findall(r"\{.*?\}", side)) for side in (text, german))
        assert same == fields, text


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


def test_every_template_is_found_again(german, update):
    """A finished sentence, whatever numbers or names are in it, is said by its own template."""
    known = update.read(TRANSLATIONS / "Bistable_de.ts")
    templates = {text for context, text in known if context == sentences.CONTEXT}
    assert len(templates) > 300
    for text in templates:
        for value in ("1.25", "body_{}"):
            filled, own = text, known[sentences.CONTEXT, text]
            for k in range(10):
                filled, own = (s.replace(f"{{{k}}}", value.format(k)) for s in (filled, own))
            assert sentences.in_own_language(filled) == own, text


SAID = {
    "Ratio of unit 2 is 0.5: for theta 80° it must be at least sin(theta/2) = 0.642788 and below "
    "1; change Ratio or make theta smaller (shorter edge or smaller Gamma).": "Ratio von Einheit 2 "
    "ist 0.5: für theta 80° muss es mindestens sin(theta/2) = 0.642788 und unter 1 sein; Ratio "
    "ändern oder theta verkleinern (kürzere Kante oder kleineres Gamma).",
    "Unit 3: Hinge leg_left: only 2.5 mm are left between its vertices and three segments need 12 "
    "mm; set EdgeLength ‖AB‖ to 80 mm, or make FaceThickness or GapLength smaller. (Also units 4, "
    "5.)": "Einheit 3: Scharnier leg_left: nur 2.5 mm bleiben zwischen seinen Ecken, und drei "
    "Glieder brauchen 12 mm; EdgeLength ‖AB‖ auf 80 mm einstellen, oder FaceThickness oder "
    "GapLength verkleinern. (Auch Einheiten 4, 5.)",
    "Layers of 0.2 mm lay 3 mm² of b directly on a (and of 2 other pairs), which welds them.":
    "Schichten von 0.2 mm legen 3 mm² von b direkt auf a (und bei 2 anderen Paaren), was sie "
    "verschweißt.",
    "3 bodies start in mid-air, tab_1 first, 8.1 mm above the bed and more than 5 mm above "
    "anything else.": "3 Körper beginnen mitten in der Luft, zuerst tab_1, 8.1 mm über dem Bett "
    "und mehr als 5 mm über allem anderen.",
    "Units 1, 2, 3 and 4 more of 9 are floppy, margin 0.50 at the least, and nothing but friction "
    "holds the deployed state.": "Einheiten 1, 2, 3 und 4 weitere von 9 sind schlaff, Reserve "
    "mindestens 0.50, und nur Reibung hält den entfalteten Zustand.",
    "Nothing fits. 12 combinations tried; cannot follow the curve: 3, as “Level: legs through a "
    "viewpoint have no level; switch Level off.”; open wider than the 60° that a sphere allows: 9. "
    "Make the curve gentler.": "Nichts passt. 12 Kombinationen versucht; können der Kurve nicht "
    "folgen: 3, wie „Level: Schenkel durch einen Blickpunkt liegen nicht waagerecht; Level "
    "ausschalten.“; öffnen weiter als die 60°, die eine Kugel erlaubt: 9. Die Kurve sanfter "
    "machen.",
    # what others say stays whole, rather than half German
    "Wire 7 is broken: ask those who made it.": "Wire 7 is broken: ask those who made it.",
}  # fmt: skip


def test_phrases_in_a_sentence_are_german_too(german):
    for sentence, own in SAID.items():
        assert sentences.in_own_language(sentence) == own


def test_sentences_stay_english_in_an_english_window(gui):
    for sentence in SAID:
        assert sentences.in_own_language(sentence) == sentence


def test_refusals_warnings_and_findings_of_objects_are_german(german, screenshot, monkeypatch):
    gui = german
    Gui.activateWorkbench("BistableWorkbench")
    doc = App.newDocument("Deutsch")
    curve = make.make_curve(doc)
    triangles = make.make_triangle_placement(doc, curve)
    unit = make.make_bistable_unit(doc, triangles)
    doc.recompute()
    triangles.EdgeLength = 5000
    doc.recompute()
    assert "is too long for this curve" in triangles.getStatusString()  # whoever reads it later
    shown = shown_in_panel(triangles, gui, lambda: screenshot("german-refusal"))
    assert any("zu lang für diese Kurve" in text for text in shown)
    triangles.EdgeLength, triangles.Thickness, unit.HingePlay = 40, 1.8, 2
    doc.recompute()
    assert "swallow the snap" in unit.Warnings[0]
    assert any("schlucken das Schnappen" in text for text in shown_in_panel(unit, gui))
    said = []
    monkeypatch.setattr(App.Console, "PrintError", said.append, raising=False)
    assert not output.write(unit, "/no such folder/tube.svg")
    assert said == [
        "Es gibt keinen Ordner /no such folder: ihn anlegen oder einen anderen wählen.\n"
    ]


def shown_in_panel(obj, gui, look=lambda: None):
    """Texts of the labels in the panel of ``obj``, which is closed again."""
    obj.ViewObject.Proxy.doubleClicked(obj.ViewObject)
    gui(0.3)
    form = Gui.getMainWindow().findChild(QtGui.QWidget, "BistablePanel")
    texts = [label.text() for label in form.findChildren(QtGui.QLabel)]
    look()
    boxes = Gui.getMainWindow().findChildren(QtGui.QDialogButtonBox)
    next(b for b in boxes if b.isVisible()).button(QtGui.QDialogButtonBox.Cancel).click()
    gui(0.2)
    return texts


def test_the_findings_of_a_check_are_german(german, screenshot):
    gui = german
    Gui.activateWorkbench("BistableWorkbench")
    coupon = make.make_hinge_coupon(App.newDocument("Probe"))
    coupon.FaceThickness, coupon.LayerHeight = 1.2, 0.25
    coupon.Document.recompute()
    panel = CheckPanel(coupon)
    Gui.Control.showDialog(panel)
    for _ in range(600):
        gui(0.1)
        if panel.done:
            break
    gui(0.3)
    shown = [label.text() for label in panel.form.findChildren(QtGui.QLabel) if label.text()]
    screenshot("german-check")
    Gui.Control.closeDialog()
    gui(0.2)
    findings = [found for several in panel.findings for found in several]
    assert len(findings) > 3
    assert all(any(sentences.finding_text(one) in text for text in shown) for one in findings)
    english = re.compile(r"\b(?:the|of|is|are|and|than|make|set|that|with)\b")
    assert not [text for text in shown if english.search(text)]
