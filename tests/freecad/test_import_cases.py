# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every case of tests/data/import as a wire in this FreeCAD: the length that was read, one path."""

from pathlib import Path

import FreeCAD as App
import pytest

from BistableWB.designs import building, reading
from BistableWB.imports import curves_in, import_curve
from BistableWB.imports.curves import wire_of

CASES = Path(__file__).resolve().parents[1] / "data" / "import"
FILES = sorted(path for path in CASES.glob("*/*") if path.name != "expected.tsv")


@pytest.mark.parametrize("folder", ["svg", "dxf", "csv"])
def test_wires_are_as_long_as_what_was_read(folder):
    if folder == "dxf":
        pytest.importorskip("ezdxf")
    for path in FILES:
        if path.parent.name != folder or path.name.startswith("24-closed"):
            continue
        for curve in curves_in(path):
            wire = wire_of(curve)
            assert wire.Length == pytest.approx(curve.length, rel=1e-5), path.name  # of OCC's rule
            assert wire.isValid(), path.name
            assert wire.isClosed() == curve.closed, path.name
            assert len(wire.OrderedEdges) == len(curve.pieces), path.name


def test_neither_preferences_nor_order_change_what_is_read(doc, valid):
    pytest.importorskip("ezdxf")
    names = ["dxf/01-units-in-m1-R2000.dxf", "svg/27-doctype-entities-illustrator.svg"]
    lengths = [curves_in(CASES / name)[0].length for name in names]
    group = App.ParamGet("User parameter:BaseApp/Preferences/Mod/Draft")
    group.SetFloat("dxfScaling", 25.4)
    group.SetInt("svgstyle", 2)
    try:
        made = [import_curve(doc, CASES / name) for name in (*names[::-1], *names)]
        valid(doc)
    finally:
        group.RemFloat("dxfScaling")
        group.RemInt("svgstyle")
    found = [curve.Length.Value for curve in made]
    assert found == pytest.approx([*lengths[::-1], *lengths], rel=1e-5)


def test_gaps_scale_and_layers_are_for_the_caller_to_say(doc, valid, tmp_path):
    path = tmp_path / "gap.svg"
    path.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="200mm" '
        'viewBox="0 0 300 200"><g id="outline"><path d="M0 0H60"/><path d="M60.5 0H100"/></g>'
        '<g id="other"><path d="M0 9H20"/></g></svg>',
        encoding="utf-8",
    )
    with pytest.raises(ValueError, match=r"curves 1 and 2 are 0\.5 mm apart at \(60\.25, "):
        import_curve(doc, path, layer="Outline")
    assert doc.Objects == []
    curve = import_curve(doc, path, layer="outline", join=1.01, scale=2)
    valid(doc)
    assert curve.Length.Value == pytest.approx(2 * 99.5)
    assert "Note: gaps of up to 1 mm are closed" in curve.Source[0].Label2
    with pytest.raises(ValueError, match="no curve on a layer x: choose one of outline, other"):
        import_curve(doc, path, layer="x")
    with pytest.raises(ValueError, match="scale is -1: give it a number above 0"):
        import_curve(doc, path, scale=-1)


def test_without_ezdxf_one_sentence_says_how_to_get_it(doc, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "ezdxf", None)
    with pytest.raises(ValueError, match="needs the Python package ezdxf, which is not installed"):
        import_curve(doc, CASES / "dxf/02-R12.dxf")
    assert doc.Objects == []


DRAWING = """<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="200mm"
viewBox="0 0 300 200"><g id="rail"><path d="M0 150H100"/><path d="M100.3 150H200"/></g>
<g id="frame"><path d="M0 0H250"/></g></svg>"""


def test_which_curve_of_a_drawing_is_for_a_design_to_say(doc, tmp_path):
    (tmp_path / "two.svg").write_text(DRAWING, encoding="utf-8")
    design = tmp_path / "two.toml"

    def build(keys):
        design.write_text(f'[curve]\nsource = "two.svg"\n{keys}', encoding="utf-8")
        return building.build(doc, reading.read(design))["curve"]

    with pytest.raises(
        reading.DesignError,
        match=r"source two.svg: .*holds 3 separate curves \(250, 100, 99.7 mm long\); the ends of "
        r"curves 2 and 3 are 0.3 mm apart at \(100.2, -150, 0\) mm",
    ):
        build("")
    curve = build('layer = "rail"\njoin = 0.7\nscale = 2\n')
    assert curve.Length.Value == pytest.approx(2 * 199.7)
    assert build("number = 3\n").Length.Value == pytest.approx(99.7)
