# SPDX-License-Identifier: LGPL-2.1-or-later
"""OpenSCAD renders our programs to the same volume, bodies and places, where it is installed."""

import FreeCAD as App
import numpy as np
import pytest

from BistableWB import checking, make
from BistableWB.checks import ERROR, NOTE
from BistableWB.exporters import export
from BistableWB.origami.meshes import Mesh
from BistableWB.origami.progress import Cancelled, Progress
from BistableWB.programs import openscad
from BistableWB.solids.tessellation import placed_meshes

pytestmark = pytest.mark.slow

ARCH = [(0, 0, 0), (60, 120, 0), (180, 120, 0), (240, 0, 0)]
needs_openscad = pytest.mark.skipif(not openscad.installed(), reason="no openscad")


def rendered(path, only=""):
    """The `Mesh` that OpenSCAD makes of a file, and the number of its bodies."""
    made = openscad.render(path, [f'only="{only}"', "sides=8"])
    assert made.complaints == []
    return made.mesh, made.bodies


@needs_openscad
@pytest.mark.parametrize("pivot", ["Cone", "Pin"])
def test_scad_of_a_unit_has_its_volume(doc, valid, tmp_path, pivot):
    unit = make.make_bistable_unit(doc, theta=60, ratio=0.55, edge_length=70)
    hinged = make.make_hinge_set(doc, unit)
    hinged.Segmentations = 3
    hinged.Pivot = pivot
    hinged.FaceThickness = 1.2 if pivot == "Cone" else 1.6
    valid(doc)
    triangles, bodies = rendered(export(hinged, tmp_path / "unit.scad"))
    assert bodies == hinged.BodyCount == 15
    assert triangles.volume == pytest.approx(hinged.Shape.Volume, rel=0.005)
    box = hinged.Shape.BoundBox
    corners = [[box.XMin, box.YMin, box.ZMin], [box.XMax, box.YMax, box.ZMax]]
    assert np.abs(triangles.bounds - np.array(corners)).max() < 0.25


@needs_openscad
@pytest.mark.parametrize("state", ["flat", "deployed"])
def test_scad_parts_of_a_tube_are_in_their_places(doc, valid, tmp_path, state):
    curve = make.make_curve(doc, points=ARCH)
    triangles = make.make_triangle_placement(doc, curve, edge_length=95)
    unit = make.make_bistable_unit(doc, triangles)
    hinged = make.make_hinge_set(doc, unit)
    hinged.Segmentations = 3
    hinged.Orientation = "OnEdge"
    hinged.Placement = App.Placement(App.Vector(1, 2, 3), App.Rotation(App.Vector(0, 0, 1), 30))
    hinged.Deployment = 0 if state == "flat" else 1
    hinged.LastUnit = 2  # ends with half of a joint
    valid(doc)
    path = export(hinged, tmp_path / "tube.scad")
    solids = dict(zip(hinged.BodyNames, hinged.Shape.Solids, strict=True))
    (half,) = (name for name in hinged.BodyNames if name.startswith("half_"))
    for name in (half, "block01_02", "unit02_link_upper", "unit02_secondary_left_lower"):
        mesh, bodies = rendered(path, name)
        assert bodies == 1
        assert mesh.volume == pytest.approx(solids[name].Volume, rel=0.005)
        box = solids[name].BoundBox
        corners = [[box.XMin, box.YMin, box.ZMin], [box.XMax, box.YMax, box.ZMax]]
        assert np.abs(mesh.bounds - np.array(corners)).max() < 0.25


@needs_openscad
def test_scad_of_any_other_solid_is_a_polyhedron(doc, valid, tmp_path):
    import Part

    box = doc.addObject("Part::Feature", 'A "box"')
    box.Shape = Part.makeBox(10, 20, 30)
    ball = doc.addObject("Part::Feature", "Ball")
    ball.Shape = Part.makeSphere(5, App.Vector(30, 0, 0))
    valid(doc)
    triangles, bodies = rendered(export([box, ball], tmp_path / "two.scad"))
    assert bodies == 2
    assert triangles.volume == pytest.approx(box.Shape.Volume + ball.Shape.Volume, rel=0.005)


@pytest.fixture
def coupon(doc, valid):
    """Meshes of a hinged dihedral with three knuckles."""
    made = make.make_hinge_coupon(doc)
    made.Segmentations = 3
    valid(doc)
    return made


@needs_openscad
def test_openscad_agrees_on_bodies_and_volume_of_a_print(coupon):
    found = [f for f in checking.check(coupon, with_openscad=True) if f.code == "openscad"]
    assert [f.severity for f in found] == [NOTE]
    assert "OpenSCAD agrees: 2 closed bodies" in str(found[0].message)
    assert found[0].number < 0.005


def broken(mesh, damage):
    if damage == "hole":
        return [mesh[0], Mesh(mesh[1].vertices, mesh[1].triangles[1:])]
    inside_out = Mesh(mesh[1].vertices, mesh[1].triangles[:, ::-1])
    return [mesh[0], inside_out]


@needs_openscad
@pytest.mark.parametrize("damage", ["hole", "inside out"])
def test_openscad_refuses_a_broken_print(coupon, damage):
    meshes = [body.placed for body in placed_meshes(checking.bodies_of(coupon))]
    (found,) = openscad.check(broken(meshes, damage))
    assert found.severity == ERROR
    assert found.cure


@needs_openscad
def test_openscad_can_be_stopped(coupon, monkeypatch):
    started = []
    start = openscad.subprocess.Popen

    def remembered(*args, **kwargs):
        started.append(start(*args, **kwargs))
        return started[-1]

    monkeypatch.setattr(openscad.subprocess, "Popen", remembered)
    meshes = [body.placed for body in placed_meshes(checking.bodies_of(coupon))]
    with pytest.raises(Cancelled):
        openscad.check(meshes, Progress(cancelled=lambda: bool(started)))  # when it runs
    assert started[0].returncode not in (None, 0)  # it was ended


def test_without_openscad_a_note_says_what_to_install(monkeypatch):
    monkeypatch.setenv("OPENSCAD", "no-such-program")
    (found,) = openscad.check([])
    assert found.severity == NOTE
    assert "install it" in str(found.message)
    with pytest.raises(openscad.NotInstalled, match="environment variable OPENSCAD"):
        openscad.program()
