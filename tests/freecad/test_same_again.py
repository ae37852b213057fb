# SPDX-License-Identifier: LGPL-2.1-or-later
"""One design gives the same bytes again, whatever Python's hashing, locale and optimisation."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from BistableWB.designs.verifying import verify
from BistableWB.origami.errors import Refusal

pytestmark = pytest.mark.slow
PYTHON = shutil.which("python3", path="/usr/bin") or shutil.which("python3")
DESIGN = """
[unit]
theta = 50
edge_length = 90
omega = 75
ratio_rule = "Exact"
[hinges]
[output]
formats = ["step", "obj", "fold", "svg", "dxf", "stl", "3mf", "scad", "glb", "xml"]
"""
SETTINGS = (
    {"PYTHONHASHSEED": "0", "LC_ALL": "C.UTF-8"},
    {"PYTHONHASHSEED": "4711", "LC_ALL": "de_DE.UTF-8", "PYTHONOPTIMIZE": "2"},
)
# What says when, where and how fast it was made; STEP and FreeCAD's own files do.
_WHEN = re.compile(rb"\d{4}-\d\d-\d\d[T ]\d\d:\d\d(:\d\d)?|[\d.,]+ s\b")


def made(folder, settings):
    """{name: bytes} of all outputs of the design."""
    folder.mkdir()
    design = folder / "unit.toml"
    design.write_text(DESIGN)
    done = subprocess.run(
        [PYTHON, "-m", "BistableWB", str(design), "--out", str(folder / "out")],
        env={**os.environ, "PATH": "/usr/bin:/bin", **settings}, capture_output=True, text=True,
        cwd=Path(__file__).parents[2], check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    files = sorted(path for path in (folder / "out").rglob("*") if path.is_file())
    return {path.name: path.read_bytes() for path in files}


@pytest.fixture(scope="module")
def outputs(tmp_path_factory):
    """[{name: bytes}] of two runs, and the folder of the first."""
    home = tmp_path_factory.mktemp("again")
    twice = [made(home / str(k), each) for k, each in enumerate(SETTINGS)]
    return twice, home / "0" / "out"


def test_outputs_are_the_same_bytes(outputs):
    first, again = outputs[0]
    suffixes = {Path(name).suffix for name in first}
    assert {".step", ".obj", ".fold", ".svg", ".dxf", ".stl", ".3mf", ".scad", ".glb"} <= suffixes
    assert set(again) == set(first)
    for name, content in first.items():
        if not name.endswith((".FCStd", ".png")):  # dated; drawn by matplotlib
            assert _WHEN.sub(b"", again[name]) == _WHEN.sub(b"", content), name


def test_outputs_are_whole(outputs):
    told = dict(verify(outputs[1]))
    assert {path.name for path in told} == set(outputs[0][0])
    assert not any(told.values())


def cut(content):
    return content[: len(content) * 3 // 5]


def moved(content):
    """Every coordinate of text and of numbers in binary a bit larger: another print."""
    if content[:5] == b"solid" or not content.isascii():
        facets = np.frombuffer(content[84:], np.dtype([("f", "<f4", 12), ("a", "<u2")])).copy()
        facets["f"] *= 1.01
        return content[:84] + facets.tobytes()
    return re.sub(rb"(-?[0-9]+[.][0-9]+)", lambda m: b"%.6f" % (float(m[1]) * 1.01), content)


@pytest.mark.parametrize(
    ("suffix", "damage"),
    [
        *((suffix, cut) for suffix in (".FCStd", ".step", ".stl", ".3mf", ".glb", ".fold", ".svg",
                                       ".xml", ".scad", ".png", ".html")),
        *((suffix, moved) for suffix in (".stl", ".obj", ".step")),
    ],
)  # fmt: skip
def test_what_is_damaged_is_found(outputs, suffix, damage, tmp_path):
    folder = tmp_path / "unit"
    shutil.copytree(outputs[1] / "unit", folder)
    victim = next(path for path in sorted(folder.iterdir()) if path.suffix == suffix)
    victim.write_bytes(damage(victim.read_bytes()))
    told = dict(verify(folder))
    assert told[victim]
    assert sum(wrong is not None for wrong in told.values()) == 1


def test_nothing_to_look_at_is_said(tmp_path):
    with pytest.raises(Refusal, match=r"no document .* give the folder that --out named"):
        list(verify(tmp_path))
