# SPDX-License-Identifier: LGPL-2.1-or-later
"""GLB as others read it: the Khronos validator, trimesh, and a browser that shows a report."""

import html
import itertools
import json
import os
import shutil
import struct
import subprocess
from pathlib import Path

import numpy as np
import pytest

from BistableWB.exporters import export
from BistableWB.exporters.glb import live_model
from BistableWB.origami import rigid
from BistableWB.reports.live_view import LIVE_STYLE, live_view, script
from tests.judges import judge

ROOT = Path(__file__).parents[2]
NPM = ROOT / "build" / "npm" / "node_modules"
VALIDATE = """
const fs = require('fs'), validator = require('gltf-validator');
validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[2])))
  .then(report => console.log(JSON.stringify(report.issues)));
"""


def parsed(path):
    data = path.read_bytes()
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20 : 20 + size]), data[20 + size + 8 :]


def array(document, binary, number):
    accessor = document["accessors"][number]
    view = document["bufferViews"][accessor["bufferView"]]
    kind = {5126: "<f4", 5123: "<u2", 5125: "<u4"}[accessor["componentType"]]
    wide = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]]
    values = np.frombuffer(binary, kind, accessor["count"] * wide, view["byteOffset"])
    return values.reshape(-1, wide)


def posed(document, binary, frame):
    """{name: vertices in mm} of every body at a frame of the animation, read as a viewer does."""
    moved = {}
    for channel in document["animations"][0]["channels"]:
        sampler = document["animations"][0]["samplers"][channel["sampler"]]
        target = channel["target"]
        moved[target["node"], target["path"]] = array(document, binary, sampler["output"])[frame]
    found = {}
    for k in document["nodes"][0]["children"]:
        node = document["nodes"][k]
        x, y, z, w = moved[k, "rotation"].astype(float)
        turn = 2 * np.array(
            [[0.5 - y * y - z * z, x * y - z * w, x * z + y * w],
             [x * y + z * w, 0.5 - x * x - z * z, y * z - x * w],
             [x * z - y * w, y * z + x * w, 0.5 - x * x - y * y]]
        )  # fmt: skip
        holder = document["nodes"][node["children"][0]]
        place = np.array(holder.get("matrix", np.eye(4).ravel())).reshape(4, 4).T
        primitive = document["meshes"][holder["mesh"]]["primitives"][0]
        points = array(document, binary, primitive["attributes"]["POSITION"]).astype(float)
        found[node["name"]] = rigid.apply(rigid.pose(turn, moved[k, "translation"]) @ place, points)
    return found


@pytest.mark.parametrize(("frame", "opening"), [(0, 0), (24, 0.5), (48, 1)])
def test_every_body_moves_as_the_solids_do(hinges, tmp_path, frame, opening):
    found = posed(*parsed(export(hinges, tmp_path / "a.glb")), frame)
    bodies = hinges.Proxy.bodies_at(hinges, opening)
    assert set(found) == {name for name, *_ in bodies}
    for name, shape, _ in bodies:
        box, points = shape.BoundBox, found[name]
        low, high = points.min(0), points.max(0)
        # chords of barrels lie inside them
        assert low == pytest.approx((box.XMin, box.YMin, box.ZMin), abs=0.1)
        assert high == pytest.approx((box.XMax, box.YMax, box.ZMax), abs=0.1)


def test_faces_of_a_tube_move_too(tube, tmp_path):
    document, binary = parsed(export(tube, tmp_path / "a.glb", frames=5))
    found = posed(document, binary, 4)
    everything = np.concatenate(list(found.values()))
    box = tube.Shape.BoundBox  # shown deployed
    assert everything.min(0) == pytest.approx((box.XMin, box.YMin, box.ZMin), abs=1e-4)
    assert everything.max(0) == pytest.approx((box.XMax, box.YMax, box.ZMax), abs=1e-4)
    flat = np.concatenate(list(posed(document, binary, 0).values()))
    assert np.linalg.svd(flat - flat.mean(0))[1][2] < 1e-3 * np.linalg.norm(flat)  # one plane


def test_the_same_bodies_give_the_same_bytes(hinges, tmp_path):
    first = export(hinges, tmp_path / "a.glb").read_bytes()
    assert export(hinges, tmp_path / "a.glb").read_bytes() == first


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("node") or not NPM.is_dir(), reason="no node with build/npm")
def test_it_is_valid_by_the_rules_of_khronos(hinges, tube, tmp_path):
    check = tmp_path / "check.cjs"
    check.write_text(VALIDATE, encoding="utf-8")
    for obj in (hinges, tube):
        path = export(obj, tmp_path / "a.glb")
        ran = subprocess.run(
            ["node", str(check), str(path)], env={**os.environ, "NODE_PATH": str(NPM)},
            capture_output=True, text=True, check=True,
        )  # fmt: skip
        issues = json.loads(ran.stdout)
        assert (issues["numErrors"], issues["numWarnings"]) == (0, 0), issues["messages"][:5]


@pytest.mark.slow
def test_trimesh_reads_metres_and_y_up(hinges, tmp_path):
    trimesh = judge("trimesh")
    scene = trimesh.load(export(hinges, tmp_path / "a.glb"))
    wide, high, deep = scene.extents * 1000  # at rest it is deployed
    size = hinges.DeployedSize
    assert (wide, deep, high) == pytest.approx((size.x, size.y, size.z), abs=0.1)
    assert len(scene.geometry) <= hinges.BodyCount
    assert len(scene.graph.nodes_geometry) == hinges.BodyCount


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("chromium"), reason="needs chromium")
def test_a_browser_shows_the_tube_flat_half_open_and_deployed(hinges, tmp_path):
    image = pytest.importorskip("PIL.Image")
    style = ":root { --line: #d9e0e6; --wash: #f5f8fa; }" + LIVE_STYLE
    page = tmp_path / "page.html"
    view = live_view(live_model(hinges, "unit"), "a <tube>", lambda text: html.escape(str(text)))
    page.write_text(f"<!DOCTYPE html><style>{style}</style>{view}{script()}", encoding="utf-8")
    seen = []
    for opening in (0, 0.5, 1):
        picture = tmp_path / f"{opening}.png"
        ran = subprocess.run(
            ["chromium", "--headless", "--no-sandbox", "--disable-quic", "--no-first-run",
             "--disable-background-networking", "--disable-component-update", "--disable-sync",
             "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--enable-logging=stderr",
             f"--user-data-dir={tmp_path / 'profile'}", "--window-size=900,640",
             "--virtual-time-budget=3000", f"--screenshot={picture}",
             f"{page.as_uri()}#opening={opening}"],
            capture_output=True, text=True, timeout=120, check=True,
        )  # fmt: skip
        assert "Uncaught" not in ran.stderr
        assert "WebGL: INVALID" not in ran.stderr
        pixels = np.asarray(image.open(picture).convert("RGB")).astype(int)[40:470, 40:840]
        coloured = np.abs(pixels - [245, 248, 250]).max(-1) > 30
        assert 0.03 < coloured.mean() < 0.7
        blue = (pixels[..., 2] - pixels[..., 0] > 60).mean()
        orange = (pixels[..., 0] - pixels[..., 2] > 60).mean()
        assert min(blue, orange) > 0.003
        seen.append(coloured)
    assert all((a != b).mean() > 0.02 for a, b in itertools.pairwise(seen))
