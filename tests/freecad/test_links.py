# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document keeps its word: links that are gone, copies, App::Link, other documents."""

from pathlib import Path

import FreeCAD as App
import numpy as np
import Part
import pytest

from BistableWB import make


@pytest.fixture
def chain(doc, valid):
    """Sketch-like source, Curve, triangles, units and a print, all valid."""
    source = doc.addObject("Part::Feature", "Rail")
    source.Shape = Part.makeCircle(150, App.Vector(), App.Vector(0, 0, 1), 0, 120)
    curve = make.make_curve(doc, source=source)
    triangles = make.make_triangle_placement(doc, curve, edge_length=60)
    unit = make.make_bistable_unit(doc, triangles)
    valid(doc)
    return source, curve, triangles, unit


GONE = "is gone: it was deleted, or not copied along"


@pytest.mark.parametrize(("deleted", "left", "name"), [(0, 1, "Source"), (1, 2, "Curve"),
                                                       (2, 3, "Triangles")])  # fmt: skip
def test_what_followed_a_deleted_object_says_so(doc, chain, refused, deleted, left, name):
    label = chain[left].Label
    doc.removeObject(chain[deleted].Name)
    assert f"{name} of {label} {GONE}" in refused(doc, chain[left])


def test_who_empties_a_link_means_it(doc, chain, valid):
    _, curve, _, unit = chain
    unit.Triangles = None
    curve.Source = None
    valid(doc)
    assert len(unit.Alphas) == 1
    assert curve.Length.Value == pytest.approx(316.1, abs=0.1)  # of its own points


def test_the_word_is_kept_in_files(doc, chain, valid, tmp_path):
    doc.UndoMode = 1
    doc.openTransaction("Delete")
    doc.removeObject(chain[2].Name)
    doc.commitTransaction()
    doc.recompute()
    path, name = str(tmp_path / "gone.FCStd"), chain[3].Name
    doc.saveAs(path)
    App.closeDocument(doc.Name)
    again = App.openDocument(path)
    try:
        unit = again.getObject(name)
        unit.touch()
        again.recompute()
        assert GONE in unit.getStatusString()
    finally:
        App.closeDocument(again.Name)


def test_files_of_0_1_0_keep_the_word_too():
    old = App.openDocument(str(Path(__file__).resolve().parents[1] / "data/chain-0.20.2.FCStd"))
    try:
        units = [obj for obj in old.Objects if "Triangles" in obj.PropertiesList and obj.Triangles]
        assert units
        old.removeObject(units[0].Triangles.Name)
        old.recompute()
        assert GONE in units[0].getStatusString()
    finally:
        App.closeDocument(old.Name)


def test_undo_of_a_deletion_makes_the_tube_again(doc, chain, valid):
    count = len(chain[3].Alphas)
    doc.UndoMode = 1
    doc.openTransaction("Delete")
    doc.removeObject(chain[2].Name)
    doc.commitTransaction()
    doc.recompute()
    doc.undo()
    for obj in doc.Objects:
        obj.touch()
    valid(doc)
    assert len(chain[3].Alphas) == count


def test_a_copy_without_its_input_is_no_other_tube(chain):
    other = App.newDocument("Other")
    try:
        copy = other.copyObject(chain[3], False)
        copy.touch()  # FreeCAD 0.20 takes a copy for made
        other.recompute()
        assert GONE in copy.getStatusString()
        whole = other.copyObject(chain[3], True)
        other.recompute()
        assert whole.isValid(), whole.getStatusString()
        assert len(whole.Alphas) == len(chain[3].Alphas)
    finally:
        App.closeDocument(other.Name)


def test_a_tube_follows_an_app_link_to_its_curve_where_the_link_stands(doc, chain, valid):
    _, curve, triangles, _ = chain
    link = doc.addObject("App::Link", "Link")
    link.LinkedObject = curve
    link.Placement = App.Placement(App.Vector(10, 20, 30), App.Rotation())
    here = np.array([tuple(v.Point) for v in triangles.Shape.Vertexes])
    moved = make.make_triangle_placement(doc, link, edge_length=60)
    valid(doc)
    there = np.array([tuple(v.Point) for v in moved.Shape.Vertexes])
    assert there - here == pytest.approx(np.tile([10, 20, 30], (len(here), 1)))
    to_triangles = doc.addObject("App::Link", "ToTriangles")
    to_triangles.LinkedObject = triangles
    unit = make.make_bistable_unit(doc, to_triangles)
    to_unit = doc.addObject("App::Link", "ToUnit")
    to_unit.LinkedObject = unit
    hinges = make.make_hinge_set(doc, to_unit)
    valid(doc)
    assert len(unit.Alphas) == triangles.Count
    assert hinges.BodyCount > 12
    doc.removeObject("ToUnit")
    doc.recompute()
    assert GONE in hinges.getStatusString()


def test_links_to_other_documents_and_refused_objects_leave_nothing(doc, chain):
    other = App.newDocument("Other")
    try:
        for attempt in (
            lambda: make.make_curve(other, source=chain[0]),
            lambda: make.make_triangle_placement(other, chain[1]),
            lambda: make.make_bistable_unit(other, chain[2]),
            lambda: make.make_hinge_set(other, chain[3]),
        ):
            with pytest.raises(ValueError, match=r"is in the document .*, and links do not leave"):
                attempt()
        with pytest.raises(ValueError, match="is unknown: choose one of"):
            make.make_curve(other, kind="Torus")
        with pytest.raises(TypeError):
            make.make_curve(other, points=[(0, 0), "abc"])
        with pytest.raises(ValueError, match="Hinge77"):
            make.make_hinge_set(other, None, preset="Hinge77")
        assert other.Objects == []
    finally:
        App.closeDocument(other.Name)


@pytest.mark.parametrize(
    ("path", "expression"),
    [
        ("Points[1].y", "Sheet.high * 2"),
        ("Points", "list(create(<<vector>>; 0; 0; 0); create(<<vector>>; 60; Sheet.high * 2; 0); "
                   "create(<<vector>>; 180; 120; 0); create(<<vector>>; 240; 0; 0))"),
    ],
    ids=["one", "all"],
)  # fmt: skip
def test_points_follow_expressions(doc, valid, path, expression):
    sheet = doc.addObject("Spreadsheet::Sheet", "Sheet")
    sheet.set("A1", "30")
    sheet.setAlias("A1", "high")
    doc.recompute()
    curve = make.make_curve(doc)
    curve.setExpression(path, expression)
    valid(doc)
    assert curve.Points[1].y == 60
    low = curve.Length.Value
    sheet.set("A1", "90")
    valid(doc)
    assert curve.Points[1].y == 180
    assert curve.Length.Value > low


def rail(doc, *edges):
    feature = doc.addObject("Part::Feature", "Pieces")
    feature.Shape = Part.makeCompound(list(edges))
    return feature


def line(a, b):
    return Part.makeLine(App.Vector(*a), App.Vector(*b))


def test_linked_edges_are_joined_as_those_of_files(doc, valid, refused):
    a, b = line((0, 0, 0), (60, 0, 0)), line((120, 0, 0), (60.008, 0, 0))
    curve = make.make_curve(doc, source=rail(doc, a, b, line((60, 0, 0), (0, 0, 0))))
    valid(doc)
    assert curve.Length.Value == pytest.approx(119.992)
    assert curve.Shape.isValid()
    assert tuple(curve.Shape.OrderedVertexes[0].Point)[1] == 0
    apart = make.make_curve(doc, source=rail(doc, a, line((60.5, 0, 0), (90, 0, 0))))
    assert "(the smallest gap is 0.5 mm at (60.25, 0, 0) mm)" in refused(doc, apart)
