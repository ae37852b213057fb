"""Bad input: one sentence, the object invalid, everything else kept."""

import math
import re

import FreeCAD as App
import Part
import pytest

from BistableWB import make

V = App.Vector
ARCH = [V(0, 0, 0), V(60, 120, 0), V(180, 120, 0), V(240, 0, 0)]


@pytest.fixture
def chain(doc, valid):
    """A valid chain; tests spoil one input of it."""
    curve = make.make_curve(doc)
    triangles = make.make_triangle_placement(doc, curve)
    unit = make.make_bistable_unit(doc, triangles)
    valid(doc)
    return {"Curve": curve, "Triangles": triangles, "Unit": unit}


CASES = [
    ("Curve", {"Points": ARCH[:1]}, "Points.*at least two control points"),
    ("Curve", {"Points": []}, "Points.*at least two"),
    ("Curve", {"Points": [V(1, 1, 1), V(1, 1, 1)]}, "points 1 and 2 coincide; move"),
    ("Curve", {"Points": [*ARCH, V(math.nan, 0, 0)]}, "control point 5 .*finite"),
    ("Curve", {"Kind": "Plane", "Points": [*ARCH[:3], V(240, 0, 90)]},
     r"not planar: near \(.*set Kind to General"),
    ("Curve", {"Kind": "Sphere", "SphereRadius": 0}, "SphereRadius is 0"),
    ("Curve", {"Kind": "Sphere", "SphereRadius": 30}, "Points reach .*SphereRadius larger"),
    ("Curve", {"Kind": "Sphere", "Points": [V(0, 0, 150), V(200, 0, 300)]},
     r"not on the sphere: at \(.*correct SphereRadius"),
    ("Triangles", {"Curve": None}, "Curve is empty: choose"),
    ("Triangles", {"EdgeLength": 0}, "EdgeLength.*above 0"),
    ("Triangles", {"EdgeLength": -5}, "EdgeLength.*above 0"),
    ("Triangles", {"EdgeLength": 700}, "EdgeLength.*shorter"),
    ("Triangles", {"Gamma": 0}, "Gamma is 0°"),
    ("Triangles", {"Gamma": 90}, "Gamma is 90°"),
    ("Triangles", {"PlacementRule": "Steered", "Tolerance": 0}, "Tolerance is 0 mm.*EndFit"),
    ("Triangles", {"PlacementRule": "Paper", "EdgeLength": 700}, "EdgeLength.*too long.*shorter"),
    ("Triangles", {"Thickness": 15}, "Thickness.*quarter of EdgeLength"),
    ("Unit", {"Ratio": 0.3}, r"Ratio of unit 1 is 0.3.*at least sin\(theta/2\).*change Ratio"),
    ("Unit", {"Ratio": 1.0}, "Ratio of unit 1 is 1.*below 1"),
    ("Unit", {"RatioShare": -0.1}, "RatioShare is -0.1: .*at least 0"),
    ("Unit", {"HeightRatio": 0}, "HeightRatio.*above 0"),
    ("Unit", {"HeightRatio": math.nan}, "HeightRatio.*nan"),
    ("Unit", {"Deployment": math.nan}, "Deployment is nan"),
    ("Unit", {"Triangles": None, "Theta": 0}, "theta of unit 1 is 0°"),
    ("Unit", {"Triangles": None, "Omega": 0}, "Omega is 0°"),
    ("Unit", {"Triangles": None, "Omega": 80, "RatioRule": "Exact", "Theta": 61},
     "theta of unit 1 is 61°.*below 60°"),
    ("Unit", {"Triangles": None, "Omega": 40, "RatioRule": "Exact", "HeightRatio": 2},
     "Strip height.*raise HeightRatio"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "values", "words"), CASES)
def test_refusal_and_recovery(doc, chain, refused, valid, name, values, words):
    obj = chain[name]
    before = {key: getattr(obj, key) for key in values}
    if "Ratio" in values:
        before["RatioRule"] = obj.RatioRule
    shape = obj.Shape.hashCode()
    for key, value in values.items():
        setattr(obj, key, value)
    sentence = refused(doc, obj)
    assert re.search(words, sentence), sentence
    assert "\n" not in sentence.strip()
    assert obj.Shape.hashCode() == shape  # nothing is lost
    for key, value in before.items():
        setattr(obj, key, value)
    valid(doc)


def spoiled(doc, shape):
    feature = doc.addObject("Part::Feature", "Source")
    feature.Shape = shape
    return feature


def polygon(*points):
    return Part.makePolygon([V(*p) for p in points])


SOURCES = [
    (polygon((0, 0), (100, 0), (0, 1)), r"turns back on itself by 179.* at \(100, 0, 0\) mm"),
    (Part.Vertex(0, 0, 0), "has no edge: link an edge"),
    (Part.makeCompound([Part.makeLine(V(0, 0, 0), V(99, 0, 0)),
                        Part.makeLine(V(0, 50, 0), V(99, 50, 0))]), "2 separate pieces"),
    (Part.Shape(), "has no edge"),
]  # fmt: skip


@pytest.mark.parametrize(("shape", "words"), SOURCES)
def test_unusable_sources(doc, chain, refused, shape, words):
    chain["Curve"].Source = (spoiled(doc, shape), [""])
    sentence = refused(doc, chain["Curve"])
    assert re.search(words, sentence), sentence


def test_sharp_knot_of_a_spline(doc, chain, refused, valid):
    spline = Part.BSplineCurve()
    poles = [V(0, 0), V(50, 0), V(100, 0), V(130, 60), V(160, 120)]
    spline.buildFromPolesMultsKnots(poles, (3, 2, 3), (0, 1, 2), False, 2)
    chain["Curve"].Source = (spoiled(doc, spline.toShape()), [""])
    valid(doc)  # the corner is rounded
    chain["Curve"].CornerRadius = 500
    assert "CornerRadius 500 mm does not fit at the corner of 63.4° at (100, 0, 0) mm" in refused(
        doc, chain["Curve"]
    )


def test_link_to_a_foreign_object(doc, chain, refused):
    box = doc.addObject("Part::Box", "Box")
    chain["Triangles"].Curve = box
    assert "links to Box" in refused(doc, chain["Triangles"])
    chain["Unit"].Triangles = chain["Curve"]
    assert "Triangles links to" in refused(doc, chain["Unit"])


def test_deleted_edge_is_named(doc, chain, refused, valid):
    feature = spoiled(doc, polygon((0, 0), (200, 0)))
    chain["Curve"].Source = (feature, ["Edge1"])
    valid(doc)
    chain["Curve"].Source = (feature, ["Edge7"])
    assert "no element Edge7" in refused(doc, chain["Curve"])


def test_deleted_link_is_named(doc, chain, refused):
    doc.removeObject(chain["Curve"].Name)
    assert "Curve of TrianglePlacement is gone" in refused(doc, chain["Triangles"])


def test_curve_fails_and_the_rest_stays(doc, chain, refused):
    faces = len(chain["Unit"].Shape.Faces)
    chain["Curve"].Points = ARCH[:1]
    refused(doc, chain["Curve"])
    assert len(chain["Unit"].Shape.Faces) == faces
    assert chain["Triangles"].Count == 23
