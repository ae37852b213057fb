# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of a user, whatever they look like, stay as they are wherever they are said."""

import html
import re

import FreeCAD as App
import pytest

from BistableWB import document_report, exporters, make
from BistableWB.imports import curves_in, import_curve
from BistableWB.objects.refused import refusal_of
from BistableWB.origami.errors import Refusal
from BistableWB.program import cli
from tests.hostile import HOSTILE

DRAWING = """<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="90mm"
xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" viewBox="0 0 200 90">
<g inkscape:groupmode="layer" inkscape:label="{layer}"><path d="M0 0H90"/></g>{more}</svg>"""


@pytest.fixture
def inches():
    """Lengths in the window in inches."""
    before = App.ParamGet("User parameter:BaseApp/Preferences/Units").GetInt("UserSchema", 0)
    App.Units.setSchema(3)
    yield
    App.Units.setSchema(before)


@pytest.mark.parametrize("name", HOSTILE)
def test_in_receipts_and_refusals_of_imports(doc, tmp_path, name):
    path = tmp_path / f"{name}.svg"
    path.write_text(DRAWING.format(layer=html.escape(name), more=""), encoding="utf-8")
    found = curves_in(path)
    assert str(found.receipt).splitlines()[0] == path.name
    assert f"Curve 1: 90 mm long, 90 mm, layer {name}" in str(found.receipt)
    with pytest.raises(Refusal) as refused:
        curves_in(path, layer=f"not {name}")
    assert str(refused.value) == (
        f"{path.name} has no curve on a layer not {name}: choose one of {name}."
    )
    curve = import_curve(doc, path)
    assert name in curve.Source[0].Label
    path.write_text(DRAWING.format(layer="a", more='<path d="M0 50H40"/>'), encoding="utf-8")
    with pytest.raises(Refusal) as refused:
        import_curve(doc, path)
    assert str(refused.value).startswith(f"{path.name} holds 2 separate curves (90, 40 mm long)")


@pytest.mark.parametrize("name", HOSTILE)
def test_in_files_that_are_not_there_or_cannot_be_written(doc, tmp_path, name):
    with pytest.raises(Refusal) as refused:
        import_curve(doc, tmp_path / f"{name}.dxf")
    assert f"{name}.dxf" in str(refused.value)
    unit = make.make_bistable_unit(doc, theta=45, edge_length=60)
    doc.recompute()
    for target in (tmp_path / name / "x.stl", tmp_path / f"x.{name}"):
        with pytest.raises(Refusal) as refused:
            exporters.export([unit], target)
        assert name in str(refused.value)


def test_in_a_report(doc, tmp_path):
    """Of labels of the document and of eleven units; as HTML, but to the letter."""
    doc.Label = " ".join(HOSTILE)
    units = []
    for label in HOSTILE:
        units.append(make.make_bistable_unit(doc, theta=45, edge_length=60))
        units[-1].Label = label
    doc.recompute()
    page = document_report.write(units, tmp_path / "x.html").read_text(encoding="utf-8")
    lines = [html.unescape(text).strip() for text in re.split(r"<[^>]*>", page)]
    for unit in units:
        assert f"{doc.Label}: {unit.Label}" in lines
        assert f"{unit.Label}: Edge length" in lines


@pytest.mark.parametrize("name", HOSTILE)
def test_on_the_command_line(capfd, tmp_path, name):
    path = tmp_path / f"{name}.toml"
    path.write_text(
        "[curve]\npoints = [[0, 0], [60, 120], [240, 0]]\n[triangles]\nedge_length = 900\n"
    )
    assert cli.main([str(path), "--out", str(tmp_path / "out")]) == 2
    (said,) = capfd.readouterr().err.splitlines()
    assert said.startswith(f"{path}: [triangles] edge_length ‖AB‖ = 900 mm is too long")
    path.write_text(f'[hinges]\n"{name}" = 1\n', encoding="utf-8")
    assert cli.main([str(path), "--out", str(tmp_path / "out")]) == 2
    (said,) = capfd.readouterr().err.splitlines()
    assert said.startswith(f"{path}: ")
    assert said.count(name) >= 2


def test_lengths_are_in_mm_whatever_unit_the_window_shows(doc, inches, tmp_path):
    triangles = make.make_triangle_placement(doc, make.make_curve(doc))
    triangles.EdgeLength = 5000
    doc.recompute()
    assert "‖AB‖ = 5000 mm is too long" in str(refusal_of(triangles))
    unit = make.make_bistable_unit(doc, theta=45, edge_length=60)
    doc.recompute()
    page = document_report.write(unit, tmp_path / "x.html").read_text(encoding="utf-8")
    assert "<td>60 mm</td>" in page
