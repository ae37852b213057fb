# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exports: what is written can be read again, and a failure leaves what was there."""

import re

import FreeCAD as App
import numpy as np
import Part
import pytest

from BistableWB import make
from BistableWB.exporters import export
from BistableWB.exporters import obj as obj_format
from BistableWB.objects.bistable_unit import tube_of


@pytest.fixture
def tube(doc, valid):
    curve = make.make_curve(doc)
    unit = make.make_bistable_unit(doc, make.make_triangle_placement(doc, curve, 80))
    valid(doc)
    return unit


@pytest.fixture
def sphere(doc, valid):
    points = [(-90, -30, 0), (-30, 60, 0), (30, 60, 0), (90, -30, 0)]
    curve = make.make_curve(doc, points, kind="Sphere", sphere_radius=150)
    unit = make.make_bistable_unit(doc, make.make_triangle_placement(doc, curve, 40, 18))
    valid(doc)
    return unit


def read_obj(path):
    """Vertices (n, 3), faces as tuples of indices from 0, group names, object names."""
    vertices, faces, groups, objects = [], [], [], []
    for line in path.read_text(encoding="utf-8").splitlines():
        kind, *rest = line.split()
        if kind == "v":
            vertices.append([float(x) for x in rest])
        elif kind == "f":
            faces.append(tuple(int(i) - 1 for i in rest))
        elif kind == "g":
            groups.append(rest[0])
        elif kind == "o":
            objects.append(rest[0])
    return np.array(vertices), faces, groups, objects


def area(vertices, faces):
    total = 0.0
    for face in faces:
        corners = vertices[list(face)]
        for k in range(1, len(corners) - 1):
            cross = np.cross(corners[k] - corners[0], corners[k + 1] - corners[0])
            total += np.linalg.norm(cross) / 2
    return total


@pytest.mark.parametrize("deployment", [0, 0.5, 1])
@pytest.mark.parametrize("suffix", ["step", "STP"])
def test_step_comes_back_with_the_same_faces(tube, tmp_path, suffix, deployment):
    tube.Deployment = deployment
    tube.Document.recompute()
    path = export([tube], tmp_path / f"tube é.{suffix}")
    shape = Part.read(str(path))
    assert len(shape.Faces) == len(tube.Shape.Faces)
    assert shape.Area == pytest.approx(tube.Shape.Area, rel=1e-9)
    header = path.read_text(encoding="ascii", errors="replace")[:600]
    assert "Bistable Workbench" in header
    assert str(tmp_path) not in header


def test_step_keeps_names_and_the_active_document(doc, tube, tmp_path):
    other = App.newDocument("Other")
    tube.Label = "My tube"
    tube.Document.recompute()
    path = export(tube, tmp_path / "tube.step")
    assert App.ActiveDocument is other
    assert sorted(App.listDocuments()) == sorted([doc.Name, other.Name])
    assert "PRODUCT('My tube'" in path.read_text()
    App.closeDocument(other.Name)


def test_step_of_a_print_has_its_solids_by_name(doc, valid, tmp_path):
    coupon = make.make_hinge_coupon(doc)
    coupon.Kind = "Vertex"
    valid(doc)
    path = export(coupon, tmp_path / "vertex.step")
    products = re.findall(r"PRODUCT\('([^']*)'", path.read_text())
    assert [name for name in products if name in coupon.BodyNames] == list(coupon.BodyNames)
    volumes = [solid.Volume for solid in Part.read(str(path)).Solids]
    assert volumes == pytest.approx([solid.Volume for solid in coupon.Shape.Solids], rel=1e-6)


@pytest.mark.parametrize("name", ["tube", "sphere"])
def test_obj_has_the_panels_by_name(name, request, tmp_path):
    unit = request.getfixturevalue(name)
    vertices, faces, groups, objects = read_obj(export([unit], tmp_path / "tube.obj"))
    count = len(unit.Alphas)
    assert objects == ["BistableUnit"]
    assert len(faces) == len(set(groups)) == 12 * count
    assert groups[0] == "unit_1_contact_left"
    assert area(vertices, faces) == pytest.approx(unit.Shape.Area, rel=1e-6)
    own = tube_of(unit).deployed().reshape(-1, 3)
    assert max(np.linalg.norm(vertices - p, axis=1).min() for p in own) < 2e-6
    assert len(vertices) == 6 * count + 4  # neighbours share their contact panel's corners


def test_obj_flat_has_the_same_area(tube, tmp_path):
    before = area(*read_obj(export(tube, tmp_path / "deployed.obj"))[:2])
    tube.Deployment = 0
    tube.Document.recompute()
    vertices, faces, *_ = read_obj(export(tube, tmp_path / "flat.obj"))
    assert area(vertices, faces) == pytest.approx(before, rel=1e-6)
    assert np.linalg.svd(vertices - vertices.mean(0))[1][2] < 1e-4  # in one plane


def test_several_objects_and_their_places(doc, tube, valid, tmp_path):
    part = doc.addObject("App::Part", "Part")
    part.Placement.Base = App.Vector(1000, 0, 0)
    box = doc.addObject("Part::Box", "Box")
    part.addObject(box)
    ball = doc.addObject("Part::Sphere", "Ball")
    ball.Label = "Box"
    valid(doc)
    vertices, faces, groups, objects = read_obj(export([box, ball, tube], tmp_path / "all.obj"))
    assert objects == ["Box", "Box001_2", "BistableUnit"] or len(set(objects)) == 3
    assert vertices[:8, 0].min() == pytest.approx(1000)
    assert max(map(max, faces)) == len(vertices) - 1
    assert {"Box_1", "Box_6"} <= set(groups)
    shape = Part.read(str(export([box, ball], tmp_path / "all.step")))
    assert len(shape.Solids) == 2
    assert shape.BoundBox.XMax == pytest.approx(1010)


@pytest.mark.parametrize("error", [OSError(28, "No space left on device"), RuntimeError("oh")])
def test_a_failure_leaves_the_old_file(tube, tmp_path, monkeypatch, error):
    path = tmp_path / "tube.obj"
    path.write_text("old")

    def fail(bodies, path):
        path.write_text("half of it")
        raise error

    monkeypatch.setattr(obj_format, "write", fail)
    with pytest.raises((ValueError, RuntimeError)):
        export(tube, path)
    assert path.read_text() == "old"
    assert [p.name for p in tmp_path.iterdir()] == ["tube.obj"]


def test_an_export_has_the_rights_of_any_new_file(tube, tmp_path):
    (tmp_path / "plain").write_text("")
    path = export(tube, tmp_path / "tube.obj")
    assert path.stat().st_mode == (tmp_path / "plain").stat().st_mode
