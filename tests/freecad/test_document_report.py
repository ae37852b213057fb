# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reports on the objects of a document, and design files written from them."""

import base64
import re
import sys

import FreeCAD as App
import numpy as np
import Part
import pytest

from BistableWB import document_report, make
from BistableWB.designs import building, reading
from BistableWB.designs.writing import CURVE_FILE, objects_of, text_of
from BistableWB.objects.bistable_unit import tube_of
from BistableWB.objects.hinge_inputs import hinge_parameters
from BistableWB.origami.progress import Cancelled

ROTATED = App.Placement(App.Vector(30, -20, 10), App.Rotation(App.Vector(1, 2, 3), 50))
MOVED = App.Placement(App.Vector(30, -20, 10), App.Rotation())


def tube(doc, unit=None, **curve):
    """A tube along a Curve with these properties."""
    made = make.make_curve(doc)
    for name, value in curve.items():
        setattr(made, name, value)
    triangles = make.make_triangle_placement(doc, made, edge_length=50, gamma=17.3)
    units = make.make_bistable_unit(doc, triangles)
    for name, value in (unit or {}).items():
        setattr(units, name, value)
    return units


def points(*rows):
    return [App.Vector(*row) for row in rows]


SPHERE = {"Kind": "Sphere", "SphereRadius": 180, "SphereCenter": App.Vector(1, 2, 3)}
PLAN = points((-110, -30, 0), (-50, 75, 0), (50, -75, 0), (110, 30, 0))
SPACE = points((0, 0, 0), (220, -60, 20), (330, 150, 40), (160, 320, 60), (-20, 260, 80))


def linked(doc):
    arc = doc.addObject("Part::Feature", "Arc")
    arc.Shape = Part.makeCircle(150, App.Vector(5, 6, 7), App.Vector(0, 0.3, 1), 0, 120)
    return tube(doc, Source=(arc, ["Edge1"]), Placement=ROTATED)


TUBES = {
    "plane": lambda doc: tube(doc),
    "moved": lambda doc: tube(doc, Placement=ROTATED),
    "ratio": lambda doc: tube(doc, {"Ratio": 0.61, "HeightRatio": 3.1}),
    "target": lambda doc: tube(
        doc, {"RatioRule": "TargetSnap", "TargetBarrier": 2e-4}, Placement=MOVED
    ),
    "sphere": lambda doc: tube(doc, {"RatioRule": "Exact"}, Points=PLAN, Placement=MOVED, **SPHERE),
    "general": lambda doc: tube(doc, {"RatioShare": 0.15}, Points=SPACE, Kind="General"),
    "general moved": lambda doc: tube(
        doc, {"RatioShare": 0.15}, Points=SPACE, Kind="General", Placement=ROTATED
    ),
    "linked": linked,
    "one unit": lambda doc: make.make_bistable_unit(doc, theta=41.7, ratio=0.5, edge_length=55),
}


def rebuilt(objects, folder):
    """The objects of the design file that is written for ``objects``, in a new document."""
    text, curve = text_of(objects, "It’s “again”")
    path = folder / "again.toml"
    path.write_text(text, encoding="utf-8")
    if curve:
        (folder / CURVE_FILE).write_text(curve)
    return building.build(App.newDocument("Again", hidden=True), reading.read(path))


@pytest.fixture
def again(tmp_path):
    made = []

    def make_again(obj):
        objects = rebuilt(objects_of(obj), tmp_path)
        made.append(objects)
        return objects

    yield make_again
    for objects in made:
        App.closeDocument(next(iter(objects.values())).Document.Name)


@pytest.mark.parametrize("kind", TUBES)
def test_the_design_file_makes_the_same_tube_again(kind, doc, valid, again):
    units = TUBES[kind](doc)
    units.Deployment = 0.4
    valid(doc)
    made = again(units)["unit"]
    old, new = tube_of(units), tube_of(made)
    for opening in (0, 1):
        off = np.abs(old.state(opening) - new.state(opening)).max()
        assert off < 1e-9 * np.abs(old.state(opening)).max()
    assert made.Deployment == 0.4
    assert made.RatioRule == units.RatioRule


def test_the_design_file_makes_the_same_print_again(doc, valid, again):
    units = tube(doc)
    units.Triangles.EdgeLength = 90
    hinges = make.make_hinge_set(doc, units)
    hinges.GapLength, hinges.ConeAngle, hinges.Bed = 0.45, 57, App.Vector(300, 300, 300)
    hinges.FirstUnit, hinges.LastUnit, hinges.Orientation = 2, 2, "OnEdge"
    valid(doc)
    made = again(hinges)["hinges"]
    assert hinge_parameters(made) == hinge_parameters(hinges)
    assert (made.Bed, made.Orientation) == (hinges.Bed, "OnEdge")
    assert made.BodyNames == hinges.BodyNames
    assert made.Shape.Volume == pytest.approx(hinges.Shape.Volume, rel=1e-9)
    assert made.Shape.BoundBox.Center.distanceToPoint(hinges.Shape.BoundBox.Center) < 1e-6


def test_the_design_file_of_a_coupon(doc, valid, again):
    coupon = make.make_hinge_coupon(doc, "Vertex", "RecommendedVertex")
    coupon.GapLength = 0.5
    valid(doc)
    made = again(coupon)["coupon"]
    assert hinge_parameters(made) == hinge_parameters(coupon)
    assert made.Shape.Volume == pytest.approx(coupon.Shape.Volume, rel=1e-9)


def test_the_report_is_one_file_that_makes_the_tube_again(doc, valid, tmp_path):
    units = linked(doc)
    valid(doc)
    path = document_report.write(units, tmp_path / "report.html")
    text = path.read_text(encoding="utf-8")
    assert text.count("data:image/png;base64,") == 3
    assert not re.findall(r'(?:src|href)="(?!data:|#)', text)
    assert [p.name for p in tmp_path.iterdir()] == ["report.html"]
    assert "What went wrong" not in text
    toml = re.search(r"<pre>(.*?)</pre>", text, re.DOTALL)[1].replace("&quot;", '"')
    curve = re.search(r'download="curve.brep" href="data:text/plain;base64,(.*?)"', text)[1]
    (tmp_path / "again.toml").write_text(toml)
    (tmp_path / CURVE_FILE).write_bytes(base64.b64decode(curve))
    other = App.newDocument("Again", hidden=True)
    made = building.build(other, reading.read(tmp_path / "again.toml"))
    assert made["unit"].Shape.Area == pytest.approx(units.Shape.Area, rel=1e-9)
    App.closeDocument(other.Name)


def test_a_print_is_reported_with_its_checks(doc, valid, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    hinges = make.make_hinge_set(doc, make.make_bistable_unit(doc, theta=45, edge_length=60))
    valid(doc)
    text = document_report.write(hinges, tmp_path / "print.html").read_text(encoding="utf-8")
    assert "python3-matplotlib" in text  # says why there are no pictures
    assert "data:image" not in text
    assert "snap margin" in text
    assert 'class="findings"' in text
    assert "face_thickness = 1.2" in text


def test_what_no_design_file_can_say_is_said(doc, valid, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    units = tube(doc, {"RatioRule": "Exact"}, Points=PLAN, Placement=ROTATED, **SPHERE)
    valid(doc)
    text = document_report.write(units, tmp_path / "turned.html").read_text(encoding="utf-8")
    assert "cannot turn a plan on a sphere" in text
    assert "Make it again" not in text


def test_what_cannot_be_reported_is_refused(doc, valid, tmp_path):
    units = tube(doc)
    valid(doc)
    with pytest.raises(ValueError, match="no tube: choose"):
        document_report.write(doc.Curve, tmp_path / "x.html")
    with pytest.raises(ValueError, match=r"let it end in \.html"):
        document_report.write(units, tmp_path / "x.pdf")
    old = tmp_path / "folder" / "x.html"
    with pytest.raises(ValueError, match="make it, or choose another one"):
        document_report.write(units, old)
    units.Triangles.Gamma = 0
    doc.recompute()
    with pytest.raises(ValueError, match="is invalid, correct it first"):
        document_report.write(units, tmp_path / "x.html")


def test_a_cancelled_report_leaves_the_old_file(doc, valid, tmp_path, monkeypatch):
    units = tube(doc)
    valid(doc)
    path = tmp_path / "x.html"
    path.write_text("old")

    def cancel(*_):
        raise Cancelled

    monkeypatch.setattr(building, "tell", cancel)
    with pytest.raises(Cancelled):
        document_report.write(units, path)
    assert path.read_text() == "old"
    assert [p.name for p in tmp_path.iterdir()] == ["x.html"]
