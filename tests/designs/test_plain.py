# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints from design files where there is no FreeCAD: meshes of a whole tube, and nets."""

import subprocess
import sys

import numpy as np
import pytest

from BistableWB.origami.meshes import Mesh, component_labels, unpaired_edges
from BistableWB.program import cli

UNIT = """
[unit]
theta = 45
ratio = 0.42
[hinges]
[output]
formats = ["stl", "fold"]
pictures = false
report = false
"""


def run(folder, text, monkeypatch):
    """Exit code and folder of a design that is made where no freecadcmd is."""
    monkeypatch.setenv("FREECADCMD", str(folder / "no-such-program"))
    monkeypatch.setattr(cli.freecad, "available", lambda: False)
    path = folder / "it.toml"
    path.write_text(text, encoding="utf-8")
    return cli.main([str(path), "--out", str(folder / "out"), "--quiet"]), folder / "out" / "it"


def mesh_in(path):
    """`Mesh` of a binary STL, corners that are alike joined."""
    record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    corners = np.fromfile(path, record, offset=84)["corners"].reshape(-1, 3)
    vertices, triangles = np.unique(corners, axis=0, return_inverse=True)
    return Mesh(vertices.astype(float), triangles.reshape(-1, 3))


def test_a_unit_is_fifteen_closed_bodies_and_loose_pillars(tmp_path, monkeypatch):
    code, folder = run(tmp_path, UNIT, monkeypatch)
    assert code == cli.FAILED  # nothing was checked, and there is no document
    assert {path.name for path in folder.iterdir()} == {"it-print.stl", "it.fold"}
    mesh = mesh_in(folder / "it-print.stl")
    assert len(unpaired_edges(mesh.triangles)) == 0
    corners = np.zeros(len(mesh.vertices), int)
    corners[mesh.triangles] = component_labels(mesh.triangles, len(mesh.vertices))[:, None]
    assert (np.bincount(corners) > 16).sum() == 15  # a pillar has 8, with a base 16
    assert mesh.bounds[0, 2] == pytest.approx(0, abs=1e-6)


@pytest.mark.parametrize(
    ("text", "word"),
    [
        (UNIT.replace('"fold"', '"step"'), "step"),
        (UNIT.replace("[hinges]", '[hinges]\norientation = "OnEdge"'), "OnEdge"),
        ("[coupon]\n", "coupon"),
    ],
)
def test_what_needs_freecad_is_said(tmp_path, monkeypatch, capsys, text, word):
    code, _ = run(tmp_path, text, monkeypatch)
    assert code == 1
    assert word in capsys.readouterr().err


def test_pictures_that_are_left_out_are_a_problem(tmp_path, monkeypatch, capsys):
    code, folder = run(tmp_path, UNIT.replace("pictures = false\n", ""), monkeypatch)
    assert code == 1
    assert "pictures" in capsys.readouterr().err
    assert (folder / "it-print.stl").is_file()


def test_no_kernel_is_imported_for_it():
    program = (
        "import sys\n"
        "for name in ('FreeCAD', 'Part', 'MeshPart'): sys.modules[name] = None\n"
        "from BistableWB.designs import plain\n"
        "from BistableWB.exporters import stl, threemf, obj, svg, dxf, fold\n"
    )
    subprocess.run([sys.executable, "-c", program], check=True)
