# SPDX-License-Identifier: LGPL-2.1-or-later
"""SVG and DXF of nets, and what formats of zero thickness and OpenSCAD refuse.

ezdxf is asked where it is installed. For FOLD see test_fold.py, for OpenSCAD test_scad.py, for what
every format refuses test_export_failures.py.
"""

import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from BistableWB import make
from BistableWB.exporters import export

FORMATS = ["fold", "svg", "dxf", "scad"]


def svg_of(path):
    return ElementTree.parse(path).getroot()


def layers(root):
    label = "{http://www.inkscape.org/namespaces/inkscape}label"
    return {g.get(label): g for g in root if g.get(label)}


def svg_lines(group):
    found = []
    for path in group.iter("{http://www.w3.org/2000/svg}path"):
        pairs = [p.split(",") for p in path.get("d").strip("MZ ").split()]
        found.append(np.array(pairs, float))
    return found


def test_svg_is_to_scale_with_layers(unit, tmp_path):
    root = svg_of(export(unit, tmp_path / "net.svg", tabs=True))
    assert (root.get("width"), root.get("height")) == ("297mm", "210mm")
    assert root.get("viewBox") == "0 0 297 210"
    groups = layers(root)
    assert set(groups) == {"cut", "mountain", "valley", "label", "sheet"}
    folds = svg_lines(groups["mountain"]) + svg_lines(groups["valley"])
    lengths = [np.linalg.norm(line[1] - line[0]) for line in folds]
    assert sum(abs(length - 60) < 2e-4 for length in lengths) == 4  # the four A-B of the strip
    assert "unit 1" in "".join(root.itertext())


def test_svg_pages_and_colours(tube, tmp_path):
    whole = svg_of(export(tube, tmp_path / "all.svg", sheet="A4"))
    sheets = round((float(whole.get("height")[:-2]) + 10) / 220)
    assert sheets > 1
    count = 0
    for page in range(1, sheets + 1):
        one = svg_of(export(tube, tmp_path / "one.svg", sheet="A4", page=page, colours=True))
        assert one.get("height") == "210mm"
        count += len(svg_lines(layers(one)["panel"]))
    assert count == 12 * len(tube.Alphas)
    with pytest.raises(ValueError, match=f"choose page 1 to {sheets}"):
        export(tube, tmp_path / "one.svg", sheet="A4", page=sheets + 1)


def test_a_hinge_set_stands_for_its_unit(doc, unit, valid, tmp_path):
    hinged = make.make_hinge_set(doc, unit)
    unit.EdgeLength = 90
    valid(doc)
    for suffix in ("fold", "svg", "dxf"):
        one = export(unit, tmp_path / f"unit.{suffix}").read_bytes()
        assert export(hinged, tmp_path / f"hinged.{suffix}").read_bytes() == one


def test_dxf_is_sound_for_ezdxf(tube, tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    drawing = ezdxf.readfile(export(tube, tmp_path / "net.dxf", tabs=True))
    audit = drawing.audit()
    assert audit.errors == []
    assert audit.fixes == []
    space = drawing.modelspace()
    assert {e.dxf.layer for e in space} == {"CUT", "MOUNTAIN", "VALLEY", "LABEL", "SHEET"}
    cuts = [e for e in space if e.dxf.layer == "CUT" and e.is_closed]
    assert len(cuts) == len(tube.Alphas)
    svg = layers(svg_of(export(tube, tmp_path / "net.svg", tabs=True)))
    outlines = [line for line in svg_lines(svg["cut"]) if len(line) > 2]
    for polyline, line in zip(cuts, outlines, strict=True):
        sides = np.array([v.dxf.location.vec2 for v in polyline.vertices])
        assert extent(sides) == pytest.approx(extent(line), abs=1e-3)


def extent(points):
    return np.ptp(np.asarray(points, float), axis=0).tolist()


def test_dxf_comes_back_into_freecad(doc, unit, tmp_path):
    import Import

    Import.readDXF(str(export(unit, tmp_path / "net.dxf")), doc.Name)
    lengths = [e.Length for obj in doc.Objects if hasattr(obj, "Shape") for e in obj.Shape.Edges]
    assert max(lengths) < 300
    assert sum(abs(length - 60) < 1e-4 for length in lengths) >= 4


def test_scad_of_faces_is_refused(unit, tmp_path):
    with pytest.raises(ValueError, match="has faces but no solid"):
        export(unit, tmp_path / "unit.scad")
    assert list(tmp_path.iterdir()) == []


def solid(doc):
    import Part

    obj = doc.addObject("Part::Feature", "Box")
    obj.Shape = Part.makeBox(1, 2, 3)
    doc.recompute()
    return obj


def test_invalid_and_foreign_objects_are_refused(doc, unit, tmp_path):
    box = solid(doc)
    unit.EdgeLength = 200
    doc.recompute()
    for suffix in ("fold", "svg", "dxf"):
        with pytest.raises(ValueError, match="Box has no panels of zero thickness"):
            export([unit, box], tmp_path / f"a.{suffix}")
    for options, message in (
        ({"sheet": "B5"}, "Sheet 'B5' is unknown"),
        ({"sheet": "100x400"}, "at least 170 x 60"),
        ({"sheet": "170x60"}, "too large for the sheet"),
        ({"tabs": True, "tab_depth": -1}, "Tabs are -1 mm deep"),
    ):
        for suffix in ("svg", "dxf"):
            with pytest.raises(ValueError, match=message):
                export(unit, tmp_path / f"a.{suffix}", **options)
    with pytest.raises(ValueError, match="deployment_frames is -1"):
        export(unit, tmp_path / "a.fold", deployment_frames=-1)
    unit.Theta = 0
    doc.recompute()
    for suffix in FORMATS:
        with pytest.raises(ValueError, match="invalid"):
            export(unit, tmp_path / f"a.{suffix}")
    assert list(tmp_path.iterdir()) == []
