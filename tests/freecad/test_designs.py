# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a change in a document solves anew: nothing that did not change."""

import math

import FreeCAD as App
import Part
import pytest

from BistableWB import make
from BistableWB.objects.bistable_unit import design_of
from BistableWB.origami import design as designs
from BistableWB.origami import memory
from BistableWB.origami.curves import ruling
from BistableWB.origami.hinges import copies
from BistableWB.origami.thick import thick_tube as thick_tubes
from BistableWB.solids import shapes

SHORT = [(0, 0, 0), (40, 60, 0), (90, 60, 0), (130, 0, 0)]


@pytest.fixture
def solved(monkeypatch):
    """Names of the solvers that were called, in their order."""
    memory.forget()
    calls = []

    def count(owner, name):
        function = getattr(owner, name)

        def call(*args, **kwargs):
            calls.append(name)
            return function(*args, **kwargs)

        monkeypatch.setattr(owner, name, call)

    count(designs, "place")
    count(designs.tubes, "along")
    count(designs, "barrier")
    count(thick_tubes.ThickUnit, "compensated")
    return calls


@pytest.fixture
def tube(doc, valid):
    curve = make.make_curve(doc, points=SHORT)
    triangles = make.make_triangle_placement(doc, curve, edge_length=60)
    unit = make.make_bistable_unit(doc, triangles)
    hinges = make.make_hinge_set(doc, unit)
    valid(doc)
    return triangles, unit, hinges


def test_deployment_solves_nothing(doc, valid, solved, tube):
    _, unit, hinges = tube
    assert "place" in solved
    solved.clear()
    unit.Deployment = 0.3
    valid(doc)
    hinges.Deployment = 1
    valid(doc)
    assert solved == []


def test_gamma_places_once_and_as_often_as_thick_panels_ask(doc, valid, solved, tube):
    triangles, _, _ = tube
    solved.clear()
    triangles.Gamma = 21
    valid(doc)
    rounds = solved.count("compensated")
    assert 2 <= rounds <= 6
    assert solved.count("place") == solved.count("along") == rounds  # the first is the thin tube's
    assert solved.count("barrier") == 1
    solved.clear()
    triangles.Gamma = 20
    valid(doc)
    assert solved == []  # it was here before


def test_hinges_of_the_same_thickness_solve_nothing(doc, valid, solved, tube):
    _, unit, hinges = tube
    hinges.Preload = 0  # preload goes by the hinges, and the units' places by it
    valid(doc)
    solved.clear()
    hinges.GapLength = 0.45
    other = make.make_hinge_set(doc, unit)
    other.LastUnit, other.Preload = 1, 0
    valid(doc)
    assert solved == []
    hinges.FaceThickness = 1.25  # the triangles do not know of it: only the panels are made anew
    valid(doc)
    assert solved == ["compensated"]


def test_objects_share_one_design(doc, tube):
    triangles, unit, hinges = tube
    design = design_of(unit)
    assert design_of(unit) is design
    assert design.where is triangles.Proxy._design
    assert design.where.gamma == math.radians(20)
    assert hinges.Proxy._design.thin() == design


def test_the_ruling_of_a_space_curve_is_searched_once(doc, valid, monkeypatch):
    searched = []
    known = ruling._View
    monkeypatch.setattr(ruling, "_View", lambda *args: searched.append(1) or known(*args))
    points = [(0, 0, 0), (60, 120, 15), (180, 120, 40), (240, 0, 51)]
    curve = make.make_curve(doc, points=points, kind="General")
    triangles = make.make_triangle_placement(doc, curve, edge_length=60)
    make.make_bistable_unit(doc, triangles)
    valid(doc)
    assert searched == [1]


@pytest.fixture
def read(monkeypatch):
    """Boundaries of which the kernel has read a solid."""
    copies.copies_for.cache_clear()
    memory.forget()
    found, known = [], shapes._read
    monkeypatch.setattr(shapes, "_read", lambda boundary: found.append(boundary) or known(boundary))
    return found


def test_an_opened_file_makes_no_solids(doc, valid, read, tube, tmp_path):
    hinges = tube[2]
    hinges.Deployment = 0.6
    valid(doc)
    volumes = [solid.Volume for solid in hinges.Shape.Solids]
    kept = hinges.SnapMargins, hinges.MadeFrom, hinges.PrintSize
    path = tmp_path / "tube.FCStd"
    doc.saveAs(str(path))
    App.closeDocument(doc.Name)
    copies.copies_for.cache_clear()
    memory.forget()
    read.clear()
    opened = App.openDocument(str(path))
    try:
        hinges = opened.HingeSet
        opened.recompute()
        assert read == []
        assert (hinges.SnapMargins, hinges.MadeFrom, hinges.PrintSize) == kept
        assert hinges.UpToDate
        hinges.Deployment = 1
        valid(opened)
        assert read == []  # it moves those of the file
        assert [solid.Volume for solid in hinges.Shape.Solids] == pytest.approx(volumes, rel=1e-9)
        assert all(shapes.boundary_of(solid) for solid in hinges.Shape.Solids)
        hinges.GapLength = 0.45
        valid(opened)
        assert read
    finally:
        App.closeDocument(opened.Name)


def test_solids_of_other_inputs_are_not_taken_for_those_of_a_file(doc, valid, read, tube):
    hinges = tube[2]
    body = hinges.Proxy.model(hinges).bodies[0]
    boundary = body.boundary
    del boundary.__dict__["_shapes"]
    turned = body.shape.copy()
    turned.rotate(App.Vector(0, 0, 0), App.Vector(0, 0, 1), 30)
    elsewhere = Part.Shape(turned.transformGeometry(App.Matrix(1.01, 0, 0, 0, 0, 1)))
    shapes.adopt(boundary, body.place, elsewhere)
    assert boundary.__dict__["_shapes"] == {}
    shapes.adopt(boundary, body.place, body.shape)
    assert len(boundary.__dict__["_shapes"]) == 1


def test_only_units_that_changed_are_made_anew(doc, valid, read, tube):
    triangles, _, hinges = tube
    count = triangles.Count
    assert count >= 3
    read.clear()
    hinges.LastUnit = count - 1
    valid(doc)
    assert len(read) < 15  # the cut block, and what had ribs below the unit that is gone
    read.clear()
    hinges.LastUnit = 0
    valid(doc)
    assert read == []
