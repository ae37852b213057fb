# SPDX-License-Identifier: LGPL-2.1-or-later
"""German reports: their words, tables, and the names in them."""

import html
import re
import sys
import types

import FreeCAD as App
import pytest

from BistableWB import TRANSLATIONS, document_report, imports, make
from BistableWB.commands import output
from BistableWB.language.words import in_words
from BistableWB.origami.errors import Refusal
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.snap.materials import MATERIALS
from BistableWB.reports.tie_section import tie_section
from BistableWB.slicing.ways import Mode, section
from tests.hostile import HOSTILE


def visible(page):
    """What a reader of an HTML page sees, a line for each element; no design file, no programs."""
    text = re.sub(r"(?s)<(pre|style|script)\b.*?</\1>|<code>.*?</code>", "", page)
    labels = re.findall(r'(?:alt|aria-label)="(.*?)"', text)
    return [html.unescape(t).strip() for t in [*re.split(r"<[^>]*>", text), *labels] if t.strip()]


def english_in(lines, update):
    """Lines that hold the words of an English text between its fields, where German has others."""
    found, known = set(), update.read(TRANSLATIONS / "Bistable_de.ts")
    lines = set(lines) - set(known.values())
    for (_, text), german in known.items():
        for part in re.split(r"\{.*?\}", text):
            words = part.strip(" .:;,()")
            if len(words) > 3 and words not in german:  # a single word may be German elsewhere
                whole = re.compile(rf"(?<!\w){re.escape(words)}(?!\w)")
                found |= {one for one in lines if " " in words and whole.search(one)}
                found |= {words} & lines
    return found


def test_the_tables_of_ways_and_of_ties_are_german(german, update):
    ways = section([
        Mode("FDM, stand-offs", 5000.0, 9e3, 0.0, 0, 31.0, True, False, True),
        Mode("FDM, soluble", 9000.0, 8e3, None, None, 400.0, False, True),
    ])  # fmt: skip
    tied = types.SimpleNamespace(ties=[], starts=[], left_area=0.0)
    ties = tie_section(tied, [], 1.0, HingeParameters(), MATERIALS["PLA"])
    parts = [one for made in (ways, ties) for one in (*made[:2], *made.columns)]
    lines = [in_words(one) for one in (*parts, *(cell for row in ways.rows for cell in row))]
    assert english_in(lines, update) == set()
    assert "FDM, Abstandsrippen (am besten)" in lines
    assert "FDM, löslich" in lines
    assert "400.0 mm (zu groß)" in lines


@pytest.mark.parametrize("kind", ["tube", "coupon", "plate"])
def test_a_report_is_german(german, update, kind, tmp_path, monkeypatch):
    doc = App.newDocument("Bericht")
    if kind == "coupon":
        made = make.make_hinge_coupon(doc)
    elif kind == "plate":
        made = make.make_calibration_plate(doc)
    else:
        triangles = make.make_triangle_placement(doc, make.make_curve(doc))
        triangles.EdgeLength = 60
        made = make.make_hinge_set(doc, make.make_bistable_unit(doc, triangles))
        made.LastUnit = 2
    doc.recompute()
    assert made.isValid()
    if kind == "tube":
        monkeypatch.setenv("PRUSASLICER", "nowhere")  # a problem that is told
    else:
        monkeypatch.setitem(sys.modules, "matplotlib", None)
    path = tmp_path / f"{kind}.html"
    document_report.write(made, path, with_slicer=kind == "tube")
    page = path.read_text(encoding="utf-8")
    assert '<html lang="de">' in page
    lines = visible(page)
    assert len(lines) > 40
    assert english_in(lines, update) == set()
    said = [line for line in lines if re.search(r"\b(?:the|of|is|are|and|than|with)\b", line)]
    assert said == []
    titles = {"coupon": "Der Probedruck", "plate": "Die Kalibrierplatte"}
    assert titles.get(kind, "Der Druck") in lines


def test_a_report_stays_english_in_an_english_window(gui, update, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    made = make.make_hinge_coupon(App.newDocument("Report"))
    made.Document.recompute()
    page = document_report.write(made, tmp_path / "x.html").read_text(encoding="utf-8")
    assert '<html lang="en">' in page
    assert {"The test print", "moving bodies", "property"} <= english_in(visible(page), update)


def test_names_stay_as_they_are_in_german(german, tmp_path, monkeypatch):
    """In the panel of an import, in refused exports, and in a report of eleven units."""
    said = []
    monkeypatch.setattr(App.Console, "PrintError", said.append, raising=False)
    doc = App.newDocument("Namen")
    doc.Label = " ".join(HOSTILE)
    units = []
    for label in HOSTILE:
        path = tmp_path / f"{label}.csv"
        path.write_text("1,2\n1,2\n", encoding="utf-8")
        with pytest.raises(Refusal) as refused:
            imports.curves_in(path)
        assert in_words(refused.value).startswith(f"{path.name} hat 1 verschiedene Punkte")
        units.append(make.make_bistable_unit(doc, theta=45, edge_length=60))
        units[-1].Label = label
    doc.recompute()
    page = document_report.write(units, tmp_path / "x.html").read_text(encoding="utf-8")
    lines = visible(page)
    for unit in units:
        assert f"{doc.Label}: {unit.Label}" in lines
        assert f"{unit.Label}: Kantenlänge" in lines
        unit.Theta = 179.99
        doc.recompute()
        assert not unit.isValid()
        assert not output.write(unit, str(tmp_path / "tube.svg"))
        assert said.pop().startswith(f"{unit.Label} ist ungültig, zuerst berichtigen: ")
