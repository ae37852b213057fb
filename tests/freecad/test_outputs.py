# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files that designs ask for beyond the usual ones: nets, other states, curves from drawings."""

import json

import FreeCAD as App
import Mesh
import numpy as np
import pytest

from BistableWB import make
from BistableWB.designs import building, reading
from BistableWB.exporters import export
from BistableWB.objects.bistable_unit import tube_of
from BistableWB.origami.meshes import Mesh as OurMesh

UNIT = "[unit]\ntheta = 45\nedge_length = 60\n"
OUTPUT = "[output]\npictures = false\nreport = false\n"


@pytest.fixture
def made(tmp_path):
    """``made(text)``: the `produce.Result` of a design."""

    def make_design(text):
        path = tmp_path / "one.toml"
        path.write_text(text, encoding="utf-8")
        result = building.produce(reading.read(path), tmp_path / "out")
        assert result.problems == []
        return result

    return make_design


def test_a_curve_from_a_drawing(made, tmp_path):
    points = tmp_path / "points.csv"
    points.write_text("0,0\n60,120\n180,120\n240,0\n")
    text = '[curve]\nsource = "points.csv"\n[triangles]\nedge_length = 80\n'
    result = made(text + OUTPUT + "formats = []\n")
    assert [path.name for path in result.files] == ["one.FCStd"]
    points.write_text("nothing")
    with pytest.raises(reading.DesignError, match=r"source points\.csv: points\.csv"):
        made(text)


def test_formats_take_their_options(made, tmp_path):
    formats = 'formats = ["fold", "svg", "dxf"]\ndeployment_frames = 3\nsheet = "A2"\n'
    plain = made(UNIT + OUTPUT + formats)
    assert {path.suffix for path in plain.files} == {".FCStd", ".fold", ".svg", ".dxf"}
    fold = json.loads((tmp_path / "out/one.fold").read_text(encoding="utf-8"))
    assert len(fold["file_frames"]) == 1 + 3 + 2
    without = (tmp_path / "out/one.svg").read_text(encoding="utf-8")
    assert 'width="594' in without
    made(UNIT + OUTPUT + formats + "tabs = true\n")
    assert len((tmp_path / "out/one.svg").read_text(encoding="utf-8")) > len(without)


def volume(mesh):
    """In double precision: FreeCAD adds up a mesh's volume in single."""
    points, facets = mesh.Topology
    return OurMesh(np.array([tuple(p) for p in points]), np.array(facets)).volume


def test_a_print_is_written_deployed_too(made):
    states = 'formats = ["stl"]\nprint_states = ["flat", "deployed"]\n'
    files = made(UNIT + "[hinges]\n" + OUTPUT + states).files
    assert [path.name for path in files] == ["one-print.stl", "one-print-deployed.stl", "one.FCStd"]
    flat, deployed = (Mesh.Mesh(str(path)) for path in files[:2])
    assert volume(deployed) == pytest.approx(volume(flat), rel=1e-5)
    assert flat.BoundBox.ZLength < 10 < deployed.BoundBox.ZLength


def test_faces_are_written_in_any_state_wherever_they_stand(tube, valid, tmp_path):
    tube.Deployment = 0.4
    tube.Placement = App.Placement(App.Vector(1, 2, 3), App.Rotation(App.Vector(1, 1, 0), 30))
    valid(tube.Document)
    export(tube, tmp_path / "flat.obj", state="flat")
    mesh = Mesh.Mesh(str(tmp_path / "flat.obj"))
    corners = tube_of(tube).state(0).reshape(-1, 3)
    low, high = corners.min(0), corners.max(0)
    box = mesh.BoundBox
    assert (box.XMin, box.YMin, box.ZMin) == pytest.approx(tuple(low), abs=1e-5)
    assert (box.XMax, box.YMax, box.ZMax) == pytest.approx(tuple(high), abs=1e-5)
    assert tube.Deployment == 0.4
    assert "Touched" not in tube.State


def test_states_that_cannot_be_are_refused(tube, tmp_path):
    with pytest.raises(ValueError, match="state is 'open': choose one of flat, deployed"):
        export(tube, tmp_path / "x.stl", state="open")
    with pytest.raises(ValueError, match="no option 'state'"):
        export(tube, tmp_path / "x.svg", state="flat")
    plate = make.make_calibration_plate(tube.Document)
    vertex = make.make_hinge_coupon(tube.Document, "Vertex", preset=None)
    tube.Document.recompute()
    with pytest.raises(ValueError, match="cannot be deployed: export it without a state"):
        export(plate, tmp_path / "x.stl", state="deployed")
    with pytest.raises(ValueError, match="made as it is printed"):
        export(vertex, tmp_path / "x.stl", state="deployed")
    assert list(tmp_path.iterdir()) == []
