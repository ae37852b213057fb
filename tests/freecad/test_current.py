# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document keeps its word: nothing leaves it that its inputs do not say now."""

import math

import FreeCAD as App
import numpy as np
import Part
import pytest

from BistableWB import checking, document_report, make
from BistableWB.exporters import FORMATS, export
from BistableWB.objects.base import OfShape, Result

PART = App.Placement(App.Vector(300, 50, 20), App.Rotation(App.Vector(1, 2, 3), 40))
ARCH = [App.Vector(0, 0, 0), App.Vector(60, 120, 0), App.Vector(180, 120, 0), App.Vector(240, 0, 0)]


def bezier(doc):
    edge = Part.BezierCurve()
    edge.setPoles(ARCH)
    drawn = doc.addObject("Part::Feature", "Drawn")
    drawn.Shape = edge.toShape()
    return drawn


def tube(doc, curve):
    triangles = make.make_triangle_placement(doc, curve, edge_length=40)
    return triangles, make.make_bistable_unit(doc, triangles)


def corners(obj):
    """Vertices of a shape in space."""
    home = obj.getGlobalPlacement() * obj.Placement.inverse()
    return np.array([tuple(home * v.Point) for v in obj.Shape.Vertexes])


def moved(points, placement):
    return np.array([tuple(placement * App.Vector(*p)) for p in points.tolist()])


@pytest.mark.parametrize("what", ["source", "curve", "source and curve", "all", "unit"])
@pytest.mark.parametrize("nested", [False, True])
def test_the_tube_stands_on_its_curve_wherever_parts_are(doc, what, nested):
    """Whatever is inside a Part that moves, the tube is where the drawn curve is seen."""
    drawn = bezier(doc)
    curve = make.make_curve(doc, source=drawn)
    triangles, unit = tube(doc, curve)
    doc.recompute()
    at_rest = corners(unit)
    part = doc.addObject("App::Part", "Part")
    inner = part
    if nested:
        inner = doc.addObject("App::Part", "Inner")
        part.addObject(inner)
    chosen = {
        "source": [drawn],
        "curve": [curve],
        "source and curve": [drawn, curve],
        "all": [drawn, curve, triangles, unit],
        "unit": [unit],
    }[what]
    for obj in chosen:
        inner.addObject(obj)
    part.Placement = PART
    doc.recompute()
    assert unit.isValid()
    # FreeCAD takes what an object follows into the Part along with it
    inside = drawn.getParentGeoFeatureGroup() is not None
    expected = moved(at_rest, PART) if inside else at_rest
    assert corners(unit) == pytest.approx(expected, abs=1e-6)
    part.Placement = App.Placement()
    doc.recompute()
    assert corners(unit) == pytest.approx(at_rest, abs=1e-6)


def test_a_curve_moved_with_its_part_takes_its_tube_along(doc):
    curve = make.make_curve(doc)
    _, unit = tube(doc, curve)
    part = doc.addObject("App::Part", "Part")
    part.addObject(curve)
    doc.recompute()
    before = corners(unit)
    part.Placement = PART
    doc.recompute()
    assert corners(unit) == pytest.approx(moved(before, PART), abs=1e-6)


def test_a_copy_outside_of_the_part_stands_where_its_curve_is(doc):
    curve = make.make_curve(doc)
    _, unit = tube(doc, curve)
    part = doc.addObject("App::Part", "Part")
    part.addObject(unit)
    part.Placement = PART
    doc.recompute()
    copy = doc.copyObject(unit, False)
    doc.recompute()
    assert copy.getParentGeoFeatureGroup() is None
    assert corners(copy) == pytest.approx(corners(unit), abs=1e-6)


@pytest.fixture
def chain(doc):
    curve = make.make_curve(doc, points=[(0, 0, 0), (40, 80, 0), (110, 80, 0)])
    triangles = make.make_triangle_placement(doc, curve, edge_length=60)
    unit = make.make_bistable_unit(doc, triangles)
    hinges = make.make_hinge_set(doc, unit)
    doc.recompute()
    assert hinges.isValid()
    return curve, triangles, unit, hinges


def leave_refused(doc, curve, triangles):
    triangles.Gamma = 89.99
    doc.recompute()
    return "TrianglePlacement is invalid, correct it first"


def leave_touched(doc, curve, triangles):
    triangles.EdgeLength = 62
    return "TrianglePlacement is not computed yet: recompute the document first"


def leave_deleted(doc, curve, triangles):
    doc.removeObject(curve.Name)
    return "Curve of TrianglePlacement is gone"


@pytest.mark.parametrize("leave", [leave_refused, leave_touched, leave_deleted])
def test_nothing_stale_leaves_the_document(chain, tmp_path, leave):
    curve, triangles, unit, hinges = chain
    said = leave(hinges.Document, curve, triangles)
    for obj in (unit, hinges):
        for suffix in FORMATS:
            with pytest.raises(ValueError, match=said):
                export([obj], tmp_path / f"print{suffix}")
    with pytest.raises(ValueError, match=said):
        checking.check(hinges)
    with pytest.raises(ValueError, match=said):
        document_report.write(hinges, tmp_path / "report.html")
    assert not list(tmp_path.iterdir())


def test_a_refused_object_keeps_no_results(chain):
    _, triangles, unit, hinges = chain
    doc, margins = hinges.Document, list(hinges.SnapMargins)
    doc.openTransaction("Gap")
    hinges.GapLength = 50
    doc.commitTransaction()
    doc.recompute()
    assert not hinges.isValid()
    for prop in hinges.Proxy.PROPERTIES:
        if isinstance(prop, Result) and not isinstance(prop, OfShape):
            value = getattr(hinges, prop.name)
            value = getattr(value, "Value", value)
            assert value in (0, "", [], App.Vector()), prop.name
    hinges.GapLength = 0.4
    doc.recompute()
    assert hinges.isValid()
    assert list(hinges.SnapMargins) == margins
    triangles.Gamma = 89.99
    doc.recompute()
    assert triangles.Count == 0
    assert "Touched" in unit.State
    assert "Touched" in hinges.State


@pytest.mark.parametrize("of", ["unit", "triangles", "through a copy"])
def test_a_curve_cannot_follow_its_own_tube(chain, of):
    curve, triangles, unit, hinges = chain
    doc = hinges.Document
    target = {"unit": unit, "triangles": triangles}.get(of)
    if target is None:
        target = doc.addObject("Part::Mirroring", "Mirrored")
        target.Source = unit
        doc.recompute()
    curve.Source = (target, ["Edge1"])
    doc.recompute()
    assert not curve.isValid()
    assert "is itself made of Curve" in curve.getStatusString()
    curve.Source = None
    doc.recompute()
    assert all(obj.isValid() for obj in chain)


def test_a_file_of_a_newer_version_stays_one(chain, tmp_path):
    hinges = chain[-1]
    hinges.addProperty("App::PropertyFloat", "FromTheFuture", "Hinge", "What we do not know")
    hinges.FromTheFuture = 4.5
    hinges.setEditorMode("BistableVersion", 0)
    hinges.BistableVersion = 99
    path = str(tmp_path / "newer.FCStd")
    hinges.Document.saveAs(path)
    again = App.openDocument(path)
    try:
        found = again.getObject(hinges.Name)
        assert found.BistableVersion == 99
        assert found.FromTheFuture == 4.5
        assert again.getObject("Curve").BistableVersion < 99
    finally:
        App.closeDocument(again.Name)


def numbers(obj):
    """Inputs of an object that hold one number."""
    return [
        prop.name
        for prop in obj.Proxy.PROPERTIES
        if not isinstance(prop, Result)
        and isinstance(getattr(getattr(obj, prop.name), "Value", getattr(obj, prop.name)), float)
    ]


def is_sound(obj):
    """Whether all results of a valid object are finite numbers."""
    for prop in obj.Proxy.PROPERTIES:
        if isinstance(prop, Result):
            value = getattr(obj, prop.name)
            value = getattr(value, "Value", value)
            if isinstance(value, float | list | App.Vector) and not isinstance(value, str):
                numbers = [value] if isinstance(value, float) else list(value)
                if not all(isinstance(x, str) or math.isfinite(x) for x in numbers):
                    return False
    return obj.Shape.isNull() or math.isfinite(obj.Shape.BoundBox.DiagonalLength)


@pytest.mark.slow
@pytest.mark.parametrize("which", range(4), ids=["curve", "triangles", "unit", "hinges"])
@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, -1.0, 0.0, 1e300, 1e-300])
def test_no_number_makes_nonsense(chain, which, value, capfd):
    """What a spreadsheet may give: each number of each object in turn is refused, or harmless."""
    obj, doc = chain[which], chain[0].Document
    for name in numbers(obj):
        before = getattr(obj, name)
        try:
            setattr(obj, name, value)
        except (ValueError, TypeError):
            continue  # FreeCAD refuses it itself
        doc.recompute()
        for one in chain:
            assert "Touched" in one.State or not one.isValid() or is_sound(one), (name, one.Label)
        setattr(obj, name, before)
    said = capfd.readouterr()
    assert "Traceback" not in said.out + said.err
