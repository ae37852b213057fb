"""Save, reopen, change, recompute: the same as built afresh; files cross FreeCAD versions."""

import shutil
from pathlib import Path

import FreeCAD as App
import pytest

from BistableWB import make

V = App.Vector
MOVED = [V(0, 0, 0), V(60, 140, 0), V(180, 100, 0), V(240, 0, 0)]
DATA = Path(__file__).parents[1] / "data"


def chain(doc):
    curve = make.make_curve(doc)
    triangles = make.make_triangle_placement(doc, curve)
    return curve, triangles, make.make_bistable_unit(doc, triangles)


def numbers(doc):
    """All results of all our objects, and their shapes' areas and lengths."""
    found = {}
    for obj in doc.Objects:
        for name in obj.PropertiesList:
            if obj.getGroupOfProperty(name) == "Results":
                value = getattr(obj, name)
                found[obj.Name, name] = getattr(value, "Value", value)
        found[obj.Name, "shape"] = [obj.Shape.Area, obj.Shape.Length, len(obj.Shape.Faces)]
    return found


def same(one, other):
    assert one.keys() == other.keys()
    for key, value in one.items():
        assert other[key] == pytest.approx(value, rel=1e-9, abs=1e-9), key


def reopened(path):
    document = App.openDocument(str(path))
    assert all(obj.Proxy is not None for obj in document.Objects)
    return document


def test_reopened_file_recomputes_like_a_fresh_one(doc, valid, tmp_path):
    curve, _, unit = chain(doc)
    valid(doc)
    path = tmp_path / "tube.FCStd"
    doc.saveAs(str(path))
    before = numbers(doc)
    App.closeDocument(doc.Name)
    again = reopened(path)
    same(before, numbers(again))  # nothing was lost
    assert not any("Touched" in obj.State for obj in again.Objects)
    again.getObject("Curve").Points = MOVED
    again.getObject("BistableUnit").Deployment = 0.25
    valid(again)
    changed = numbers(again)
    App.closeDocument(again.Name)

    fresh = App.newDocument("Fresh")
    curve, _, unit = chain(fresh)
    curve.Points, unit.Deployment = MOVED, 0.25
    valid(fresh)
    same(changed, numbers(fresh))
    App.closeDocument(fresh.Name)


def test_invalid_object_survives_a_save(doc, refused, valid, tmp_path):
    curve, _, _ = chain(doc)
    curve.Points = MOVED[:1]
    refused(doc, curve)
    doc.saveAs(str(tmp_path / "bad.FCStd"))
    App.closeDocument(doc.Name)
    again = reopened(tmp_path / "bad.FCStd")
    again.getObject("Curve").Points = MOVED
    valid(again)
    assert again.getObject("TrianglePlacement").Count > 10
    App.closeDocument(again.Name)


def test_missing_properties_are_added_to_an_old_file(doc, valid, tmp_path):
    """A file of a version that lacked a property opens, gets it, and keeps its values."""
    _, triangles, _ = chain(doc)
    triangles.EdgeLength = 33
    triangles.removeProperty("FlipSide")
    path = tmp_path / "old.FCStd"
    doc.saveAs(str(path))
    App.closeDocument(doc.Name)
    again = reopened(path)
    assert again.getObject("TrianglePlacement").FlipSide is False
    assert again.getObject("TrianglePlacement").EdgeLength.Value == 33
    valid(again)
    App.closeDocument(again.Name)


def test_repair_gives_lost_proxies_back(doc, valid):
    """What a save on a FreeCAD without the workbench leaves: no proxies, all properties."""
    curve, _, unit = chain(doc)
    valid(doc)
    before = numbers(doc)
    for obj in (curve, unit):
        obj.Proxy = None
    assert make.repair(doc) == [curve, unit]
    valid(doc)
    same(before, numbers(doc))
    assert make.repair(doc) == []
    curve.Points = MOVED
    valid(doc)
    assert numbers(doc) != before


def test_file_of_freecad_0_20_opens_here(valid, tmp_path):
    path = shutil.copy(DATA / "chain-0.20.2.FCStd", tmp_path)
    old = reopened(path)
    saved = {key: value for key, value in numbers(old).items() if value}  # not newer results
    old.getObject("Curve").touch()
    valid(old)
    same(saved, {key: value for key, value in numbers(old).items() if key in saved})
    assert old.getObject("BistableUnit").RatioRule == "Fixed"
    assert old.getObject("TrianglePlacement").PlacementRule == "Paper"
    assert old.getObject("Curve").Kind == "Plane"
    old.getObject("Curve").Points = MOVED
    valid(old)
    assert numbers(old) != saved
    App.closeDocument(old.Name)
