# SPDX-License-Identifier: LGPL-2.1-or-later
"""OpenSCAD renders our programs to the same volume, bodies and places, where it is installed."""

import shutil
import subprocess

import FreeCAD as App
import numpy as np
import pytest

from BistableWB import make
from BistableWB.exporters import export

pytestmark = pytest.mark.slow

ARCH = [(0, 0, 0), (60, 120, 0), (180, 120, 0), (240, 0, 0)]
needs_openscad = pytest.mark.skipif(not shutil.which("openscad"), reason="no openscad")


def rendered(path, only="", state=None):
    """Triangles (n, 3, 3) that OpenSCAD makes of a file, and the number of its bodies."""
    out = path.with_suffix(".stl")
    settings = ["-D", f'only="{only}"', "-D", "sides=8"]
    if state is not None:
        settings += ["-D", f"state={state}"]
    ran = subprocess.run(
        ["openscad", *settings, "-o", str(out), str(path)],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert "WARNING" not in ran.stderr, ran.stderr
    assert "ERROR" not in ran.stderr, ran.stderr
    words = [line.split()[1:] for line in out.read_text().splitlines() if "vertex" in line]
    volumes = next(line for line in ran.stderr.splitlines() if "Volumes:" in line)
    return np.array(words, float).reshape(-1, 3, 3), int(volumes.split()[-1]) - 1


def volume(triangles):
    a, b, c = np.moveaxis(triangles - triangles.reshape(-1, 3).mean(0), 1, 0)
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


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
    assert volume(triangles) == pytest.approx(hinged.Shape.Volume, rel=0.005)
    box = hinged.Shape.BoundBox
    corners = [[box.XMin, box.YMin, box.ZMin], [box.XMax, box.YMax, box.ZMax]]
    reach = triangles.reshape(-1, 3)
    assert np.abs([reach.min(0), reach.max(0)] - np.array(corners)).max() < 0.25


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
    valid(doc)
    path = export(hinged, tmp_path / "tube.scad")
    solids = dict(zip(hinged.BodyNames, hinged.Shape.Solids, strict=True))
    for name in ("block01_02", "unit02_link_upper", "unit02_secondary_left_lower"):
        mesh, bodies = rendered(path, name)
        assert bodies == 1
        assert volume(mesh) == pytest.approx(solids[name].Volume, rel=0.005)
        box = solids[name].BoundBox
        corners = [[box.XMin, box.YMin, box.ZMin], [box.XMax, box.YMax, box.ZMax]]
        reach = mesh.reshape(-1, 3)
        assert np.abs([reach.min(0), reach.max(0)] - np.array(corners)).max() < 0.25


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
    assert volume(triangles) == pytest.approx(box.Shape.Volume + ball.Shape.Volume, rel=0.005)
