# SPDX-License-Identifier: LGPL-2.1-or-later
"""German: complete, up to date, and what the window shows."""

import re
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
import Part
import pytest
from PySide import QtCore, QtGui

from BistableWB import RESOURCES, TRANSLATIONS, imports, make
from BistableWB.commands import COMMANDS, files, output
from BistableWB.language.words import in_words
from BistableWB.objects import TYPES, proxy_class
from BistableWB.origami.errors import Choice, Refusal, phrase, verbatim
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.snap.materials import MATERIALS
from BistableWB.taskpanels.check import CheckPanel
from tests.hostile import HOSTILE


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


def test_sentences_call_a_choice_what_the_panel_calls_it(update):
    """But where a value of a macro is unknown: there its English name is what must be written."""
    known = update.read(TRANSLATIONS / "Bistable_de.ts")
    choices = {one: known[update.TABLES, one] for one in update.CHOICES}
    english = [one for one, own in choices.items() if one.lower() not in own.lower()]
    named = re.compile("|".join(rf"\b{one}\b" for one in english))
    found = {
        text: german
        for (context, text), german in known.items()
        if context == "BistableSentence" and "unbekannt" not in german and named.search(german)
    }
    assert found == {}


def test_every_choice_of_a_panel_is_translated(update):
    """But names of materials and of columns of the paper's tables."""
    names = re.compile(r"Hinge\d|" + "|".join(map(re.escape, MATERIALS)))
    choices = {
        one
        for name in TYPES
        for prop in proxy_class(name).PROPERTIES
        if prop.kind == "Enumeration" and prop.default
        for one in prop.default
    }
    assert {one for one in choices if not names.fullmatch(one)} <= set(update.CHOICES)


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


SAID = {
    phrase(
        "Unit {unit}: {note}",
        unit=3,
        note=phrase("Hinge {hinge} has room for {count} segments instead of {wanted}.",
                    hinge="wall", count=3, wanted=5),
    ): "Einheit 3: Scharnier wall hat Platz für 3 Glieder statt 5.",
    Refusal(
        "{Level}: legs through a viewpoint have no level; switch {Level} off.", parameter="Level"
    ): "Waagerecht: Schenkel durch einen Blickpunkt liegen nicht waagerecht; Waagerecht "
    "ausschalten.",
    verbatim("Wire 7 of unit 3 is broken: ask those who made it."): "Wire 7 of unit 3 is broken: "
    "ask those who made it.",
}  # fmt: skip


def test_phrases_in_a_sentence_are_german_too(german):
    for said, own in SAID.items():
        assert in_words(said) == own


def test_choices_in_a_sentence_are_what_the_panels_call_them(german, screenshot):
    with pytest.raises(Refusal) as refused:
        HingeParameters(process="Powder", gap_length=0.1).check()
    assert "Powder keeps no gap" in str(refused.value)
    assert "Pulver" in in_words(refused.value)
    assert "Powder" not in in_words(refused.value)
    said = phrase("{Material}: {material} ({label})", material=Choice("Resin"), label="Resin")
    assert in_words(said) == "Werkstoff: Harz (Resin)"
    Gui.activateWorkbench("BistableWorkbench")
    doc = App.newDocument("Auswahl")
    curve = make.make_curve(doc)
    doc.recompute()
    shown = shown_in_panel(curve, german, lambda: screenshot("german-curve"))
    assert curve.FoundKind == "Plane"
    assert "Ebene" in shown
    assert "Plane" not in shown


PICTURE = """<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="90mm"
viewBox="0 0 200 90"><path d="M0 0 L100 50 L190 80" stroke="red" fill="none"/>
<g display="none"><path d="M0 0 L9 9" stroke="red"/></g><text>hidden</text></svg>"""


def test_what_an_import_left_out_is_told_in_german(german, tmp_path):
    path = tmp_path / "group.svg"
    path.write_text(PICTURE, encoding="utf-8")
    told = [in_words(one) for one in imports.curves_in(path).receipt.phrases()]
    assert "Ausgelassen: 1 × Gruppe (nicht angezeigt)" in told
    assert "Ausgelassen: 1 × Text (kein Pfad: in einen Pfad umwandeln)" in told


def test_sentences_stay_english_in_an_english_window(gui):
    refusal = list(SAID)[1]
    assert in_words(refusal) == str(refusal)


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
    # what the tree's tooltip and the report view show
    assert "zu lang für diese Kurve" in triangles.getStatusString()
    assert "is too long for this curve" in str(triangles.Proxy.refusal)
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
    assert all(any(in_words(one) in text for text in shown) for one in findings)
    english = re.compile(r"\b(?:the|of|is|are|and|than|make|set|that|with)\b")
    assert not [text for text in shown if english.search(text)]


@pytest.mark.parametrize("label", ["wall", "Unit 1", "{0}", "{EdgeLength}", "of unit 3"])
def test_a_label_stays_as_it_is_in_german(german, label):
    assert label in HOSTILE
    Gui.activateWorkbench("BistableWorkbench")
    doc = App.newDocument("Namen")
    source = doc.addObject("Part::Feature", "Pieces")
    lines = (((0, 0, 0), (100, 0, 0)), ((100, 50, 0), (100, 150, 0)))
    source.Shape = Part.makeCompound([Part.makeLine(*map(App.Vector, line)) for line in lines])
    source.Label = label
    curve = make.make_curve(doc, source=source)
    doc.recompute()
    shown = shown_in_panel(curve, german)
    told = f"Vorlage {label} zerfällt in 2 getrennte Stücke (die kleinste Lücke ist 50 mm "
    assert [text for text in shown if text.startswith(told)]


def test_a_refusal_is_told_beside_the_field_of_its_parameter(german):
    Gui.activateWorkbench("BistableWorkbench")
    doc = App.newDocument("Winkel")
    triangles = make.make_triangle_placement(doc, make.make_curve(doc))
    triangles.Gamma = 120
    doc.recompute()
    beside = {}

    def look():
        form = Gui.getMainWindow().findChild(QtGui.QWidget, "BistablePanel")
        for label in form.findChildren(QtGui.QLabel):
            if label.objectName().endswith("_error") and label.text():
                beside[label.objectName()] = label.text()

    shown_in_panel(triangles, german, look)
    assert list(beside) == ["Gamma_error"]
    assert beside["Gamma_error"].startswith("Gamma ist 120°: ")


def test_refusals_and_receipts_of_imports_are_in_german(german, tmp_path):
    path = tmp_path / "choose a curve.csv"  # a name that is itself a text of ours
    path.write_text("1,2\n1,2\n")
    with pytest.raises(Refusal, match="different points") as refused:
        imports.curves_in(path)
    said = in_words(refused.value)
    assert said.startswith("choose a curve.csv hat 1 verschiedene Punkte: gib einen Punkt je Zeile")
    path.write_text("0,0\n60,40\n120,0\n")
    told = [in_words(one) for one in imports.curves_in(path).receipt.phrases()]
    assert told == ["Einheit: mm (keine Einheit angegeben: als mm gelesen)"]
