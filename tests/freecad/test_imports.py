# SPDX-License-Identifier: LGPL-2.1-or-later
"""Curves from SVG, DXF and CSV, units from our own FOLD; every other file is refused by name."""

import json
import math

import FreeCAD as App
import numpy as np
import Part
import pytest

from BistableWB import make
from BistableWB.exporters import export
from BistableWB.imports import curve_points, import_curve, import_fold, read_unit

SVG = """<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="200mm" viewBox="0 0 300 200">
<g transform="translate(10,0)">{}</g></svg>"""
ARCH = '<path d="M0 150 C 60 30 180 30 240 150"/>'

DXF_ARCS = """0
SECTION
2
ENTITIES
0
LINE
8
0
10
0.0
20
0.0
11
100.0
21
0.0
0
ARC
8
0
10
100.0
20
80.0
40
80.0
50
270.0
51
0.0
0
ENDSEC
0
EOF
"""


def file(folder, name, content):
    path = folder / name
    path.write_text(content, encoding="utf-8")
    return path


def ends(points):
    return [tuple(round(x, 6) + 0.0 for x in points[i]) for i in (0, -1)]


def test_svg_path_becomes_a_curve(doc, valid, tmp_path):
    path = file(tmp_path, "arch.svg", SVG.format(ARCH))
    before = set(App.listDocuments())
    curve = import_curve(doc, path)
    valid(doc)
    assert set(App.listDocuments()) == before
    assert App.ActiveDocument.Name == doc.Name
    assert curve.Label == "arch (curve)"
    points = np.array(curve_points(path))
    assert sorted(ends(points)) == [(10, -150, 0), (250, -150, 0)]  # y points up here
    assert points[:, 1].max() == pytest.approx(-60, abs=0.02)  # the top of that Bézier
    bezier = 240 * np.linspace(0, 1, 2001)
    assert curve.Length.Value == pytest.approx(_arch_length(bezier / 240), rel=1e-6)
    triangles = make.make_triangle_placement(doc, curve)
    valid(doc)
    assert triangles.Count > 5


def _arch_length(s):
    x = 3 * (1 - s) ** 2 * s * 60 + 3 * (1 - s) * s**2 * 180 + s**3 * 240
    y = (1 - s) ** 3 * 150 + 3 * (1 - s) ** 2 * s * 30 + 3 * (1 - s) * s**2 * 30 + s**3 * 150
    return np.hypot(np.diff(x), np.diff(y)).sum()


def test_dxf_becomes_a_curve(doc, valid, tmp_path):
    path = file(tmp_path, "arcs.dxf", DXF_ARCS)
    curve = import_curve(doc, path, name="Rail")
    valid(doc)
    assert curve.Length.Value == pytest.approx(100 + 80 * math.pi / 2)
    assert curve.Label == "Rail (curve)"
    assert sorted(ends(curve_points(path))) == [(0, 0, 0), (180, 80, 0)]
    triangles = make.make_triangle_placement(doc, curve, edge_length=30)
    valid(doc)
    assert triangles.Count > 3


@pytest.mark.parametrize(
    "text",
    [
        "0,0\n60,40\n120,50\n180,40\n240,0\n",
        "x,y\n0,0\n60,40\n120,50\n180,40\n240,0",
        "# sketched\r\n0;0;0\r\n60,0;40,0;0\r\n120;50;0\r\n\r\n180;40;0\r\n240;0;0;\r\n",
        "\ufeffx [mm]; y [mm]; z [mm]\n0;0;0\n60;40;0\n120;50;0\n180;40;0\n240;0;0\n",
        "0 0\n60\t40\n120 50\n180 40\n240 0\n240 0\n",
        'name,"y","x"\na,0,0\nb,40,60\nc,50,120\nd,40,180\ne,0,240\n',
    ],
)
def test_table_of_points_becomes_a_smooth_curve(doc, valid, tmp_path, text):
    path = file(tmp_path, "points.csv", text)
    points = curve_points(path)
    assert points == [(0, 0, 0), (60, 40, 0), (120, 50, 0), (180, 40, 0), (240, 0, 0)]
    curve = import_curve(doc, path)
    valid(doc)
    for point in points:
        vertex = Part.Vertex(App.Vector(*point))
        assert curve.Shape.distToShape(vertex)[0] < 1e-6
    make.make_triangle_placement(doc, curve)
    valid(doc)


def test_fine_polygon_is_read_as_the_curve_through_its_corners(doc, valid, tmp_path):
    angles = np.linspace(0, math.pi / 2, 12)
    corners = " ".join(f"{100 * math.cos(a):.6f},{100 * math.sin(a):.6f}" for a in angles)
    path = file(tmp_path, "p.svg", SVG.format(f'<path d="M {corners}" fill="none"/>'))
    curve = import_curve(doc, path)
    valid(doc)
    assert curve.Length.Value == pytest.approx(50 * math.pi, rel=1e-3)


def test_corners_stay_corners_and_the_curve_rounds_them(doc, valid, tmp_path):
    path = file(tmp_path, "zigzag.svg", SVG.format('<path d="M0 0 L50 0 L50 50 L100 50 L100 90"/>'))
    assert len(curve_points(path)) == 5
    curve = import_curve(doc, path)
    curve.CornerRadius = 10
    valid(doc)
    # three arcs of a quarter in place of twice their radius each
    assert curve.Length.Value == pytest.approx(190 - 3 * (20 - 5 * np.pi), rel=1e-4)


def test_one_of_several_curves_is_chosen_by_number(doc, valid, tmp_path):
    two = SVG.format(ARCH + '<path d="M0 0 L50 0"/>')
    path = file(tmp_path, "two.svg", two)
    with pytest.raises(
        ValueError, match=r"two\.svg holds 2 separate curves \(3\d\d.*, 50 mm long\)"
    ):
        import_curve(doc, path)
    assert doc.Objects == []
    assert import_curve(doc, path, number=2)
    valid(doc)
    assert ends(curve_points(path, number=2))[0][1] == 0
    with pytest.raises(ValueError, match="has no curve 3"):
        curve_points(path, number=3)


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("a.svg", "<svg><path d='M0", "a.svg is not a whole SVG file"),
        ("a.svg", "<html/>", "a.svg is not an SVG file"),
        ("a.svg", SVG.format("<text>hello</text>"), "a.svg holds no line or curve"),
        ("a.svg", SVG.format('<path d="M0 0 C 1"/>'), "a.svg (cannot be read|holds no line)"),
        ("a.dxf", "hello", "a.dxf is not a whole DXF file"),
        ("a.dxf", DXF_ARCS.replace("EOF", ""), "a.dxf is not a whole DXF file"),
        ("a.dxf", "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n", "holds no line or curve"),
        ("a.csv", "", "a.csv has 0 different points"),
        ("a.csv", "x,y\n", "a.csv has 0 different points"),
        ("a.csv", "1,2\n1,2\n", "a.csv has 1 different points"),
        ("a.csv", "1,2\n3,x\n", "a.csv, line 2: 'x' is not a coordinate"),
        ("a.csv", "1,2\n\n3,nan\n", "a.csv, line 3: 'nan' is not a coordinate"),
        ("a.csv", "1,2\n3,inf\n", "a.csv, line 2: 'inf'"),
        ("a.csv", "1,2\n3,1e9\n", "a.csv, line 2: the point lies 1e\\+09 mm from the others"),
        ("a.csv", "1,2\n3\n", "a.csv, line 2: 1 columns"),
        ("a.csv", "1,2,3,4\n5,6,7,8\n", "a.csv, line 1: 4 columns"),
        ("a.csv", "x (miles),y (miles)\n1,2\n3,4\n", "a unit that is not known: convert"),
        ("a.csv", "lat,lon\n1,2\n3,4\n", "a.csv has angles or pixels"),
        ("a.txt", "hello world\n", "a.txt has 0 different points"),
        ("a.png", "", r"a.png has the suffix \.png: choose one of \.svg, \.svgz, \.dxf"),
        ("noname", "", "noname has no suffix"),
    ],
)
def test_broken_curve_files_are_refused(doc, tmp_path, name, content, message):
    path = file(tmp_path, name, content)
    before = set(App.listDocuments())
    with pytest.raises(ValueError, match=message):
        import_curve(doc, path)
    assert doc.Objects == []
    assert set(App.listDocuments()) == before


@pytest.mark.parametrize("name", ["a.svg", "a.dxf", "a.csv", "a.fold"])
def test_missing_and_binary_files_are_refused(doc, tmp_path, name):
    read = import_fold if name == "a.fold" else import_curve
    with pytest.raises(ValueError, match="There is no file"):
        read(doc, tmp_path / name)
    with pytest.raises(ValueError, match="There is no file"):
        read(doc, tmp_path)
    (tmp_path / name).write_bytes(b"\xff\xd8\x00\x80binary")
    with pytest.raises(ValueError, match=f"{name} is not a text file"):
        read(doc, tmp_path / name)
    assert doc.Objects == []


def plane(doc):
    unit = make.make_bistable_unit(doc, theta=47.3, ratio=0.51, edge_length=61.7, height_ratio=2.3)
    unit.Placement = App.Placement(App.Vector(3, -4, 5), App.Rotation(App.Vector(1, 2, -1), 77))
    return unit


def spherical(doc, rule="Exact"):
    unit = make.make_bistable_unit(doc, theta=52, edge_length=80)
    unit.Omega = 71.5
    unit.RatioRule = rule
    return unit


def adaptive(doc):
    return make.make_bistable_unit(doc, theta=45, edge_length=60)


def paper(doc):
    return spherical(doc, "Paper")


@pytest.mark.parametrize("build", [plane, adaptive, spherical, paper])
def test_unit_comes_back_from_fold(doc, valid, tmp_path, build):
    unit = build(doc)
    valid(doc)
    again = import_fold(doc, export(unit, tmp_path / "unit.fold"))
    valid(doc)
    for opening in (1.0, 0.0, 0.4):
        unit.Deployment = again.Deployment = opening
        valid(doc)
        assert corners(again) == pytest.approx(corners(unit), abs=1e-9)
    for name in ("Alphas", "Betas", "BetaPrimes", "Ratios"):
        assert getattr(again, name) == pytest.approx(getattr(unit, name), rel=1e-12)
    for name in ("Theta", "Omega", "EdgeLength"):
        assert getattr(again, name).Value == pytest.approx(getattr(unit, name).Value, rel=1e-12)
    assert again.HeightRatio == pytest.approx(unit.HeightRatio, rel=1e-12)


def corners(unit):
    return np.array([tuple(v.Point) for face in unit.Shape.Faces for v in face.Vertexes])


@pytest.mark.parametrize("kind", ["Plane", "Sphere"])
def test_any_unit_of_a_tube_comes_back_where_it_stands(doc, valid, tmp_path, kind):
    points = [(-60, 0, 0), (0, 50, 0), (60, 0, 0)]
    curve = make.make_curve(doc, points=points, kind=kind, sphere_radius=120)
    triangles = make.make_triangle_placement(doc, curve, edge_length=40)
    tube = make.make_bistable_unit(doc, triangles)
    if kind == "Sphere":
        tube.RatioRule = "Exact"  # a unit of any other ratio is one of a general curve
    valid(doc)
    path = export(tube, tmp_path / "tube.fold")
    count = len(tube.Alphas)
    with pytest.raises(ValueError, match=f"tube.fold holds {count} units: say which, 1 to {count}"):
        import_fold(doc, path)
    with pytest.raises(ValueError, match=f"has no unit {count + 1}: choose 1 to {count}"):
        import_fold(doc, path, unit=count + 1)
    whole = corners(tube)
    for k in range(1, count + 1):
        unit = import_fold(doc, path, unit=k)
        valid(doc)
        for point in corners(unit):
            assert np.linalg.norm(whole - point, axis=1).min() < 1e-6


def test_foreign_and_changed_fold_files_are_refused(doc, valid, tmp_path):
    unit = adaptive(doc)
    valid(doc)
    good = json.loads(export(unit, tmp_path / "good.fold").read_text())
    count = len(doc.Objects)

    def refused(content, message):
        text = content if isinstance(content, str) else json.dumps(content)
        with pytest.raises(ValueError, match=message):
            import_fold(doc, file(tmp_path, "bad.fold", text))
        assert len(doc.Objects) == count

    foreign = {"file_spec": 1.1, "file_creator": "Crane", "vertices_coords": [[0, 0]]}
    refused(foreign, "bad.fold was made by Crane: only FOLD files exported by Bistable Workbench")
    refused({"file_spec": 1}, "was made by another program")
    refused('{"file_spec": 1.1, ', "bad.fold is not a whole FOLD file")
    refused("[1, 2]", "bad.fold is not a FOLD file")
    refused({"a": 1}, "bad.fold is not a FOLD file")
    moved = json.loads(json.dumps(good))
    moved["vertices_coords"][0][0] += 0.01
    refused(moved, "the file was changed")
    for key, value, message in (
        ("vertices", [0, 1, 2], "ten corners"),
        ("vertices", [99] * 10, "unit 1 in bistable:units is broken"),
        ("vertices", "abc", "is broken"),
        ("theta", None, "is broken"),
        ("edge_length", -1, "lengths that no unit has"),
        ("theta", float("nan"), "lengths that no unit has|finite"),
        ("omega", 120, "not the symmetric unit"),
        ("omega", 80, "not the symmetric unit"),
    ):
        broken = json.loads(json.dumps(good))
        broken["bistable:units"][0][key] = value
        refused(broken, message)
    del good["vertices_coords"]
    refused(good, "is broken")
    good["bistable:units"] = []
    refused(good, "was made by Bistable Workbench")


def test_read_unit_needs_no_document(doc, valid, tmp_path):
    unit = plane(doc)
    valid(doc)
    read = read_unit(export(unit, tmp_path / "unit.fold"))
    assert read.theta == pytest.approx(47.3, rel=1e-15)
    assert read.rule == "Fixed"
    assert read.place[:3, 3] == pytest.approx([3, -4, 5], abs=1e-9)
