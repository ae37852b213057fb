# SPDX-License-Identifier: LGPL-2.1-or-later
"""``pip install`` gives a library that works without FreeCAD, with its resources."""

import json
import os
import subprocess
import sys
import tomllib
from pathlib import Path

import numpy as np
import pytest

from BistableWB.designs import library
from BistableWB.designs.reading import read
from BistableWB.origami.errors import Refusal

ROOT = Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "resources/examples"


def run(python, code, *arguments, **environment):
    done = subprocess.run(
        [python, "-c", code, *map(str, arguments)], capture_output=True, text=True, check=False,
        cwd="/", env={**os.environ, **environment},
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout.splitlines()[-1])


IMPORT_ALL = """
import importlib, json, pkgutil, sys
import BistableWB.origami as origami
for module in pkgutil.walk_packages(origami.__path__, "BistableWB.origami."):
    importlib.import_module(module.name)
foreign = ("FreeCAD", "Part", "PySide", "pivy", "scipy", "matplotlib")
print(json.dumps([name for name in sys.modules if name.startswith(foreign)]))
"""


def test_the_mathematics_pulls_in_neither_freecad_nor_a_window():
    assert run(sys.executable, IMPORT_ALL, PYTHONPATH=str(ROOT)) == []


def test_every_package_and_resource_is_installed():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    listed = set(project["tool"]["setuptools"]["packages"])
    ours = {
        ".".join(path.parent.relative_to(ROOT).parts)
        for path in (ROOT / "BistableWB").rglob("__init__.py")
    }
    used = ("examples", "help", "icons", "report", "translations")
    folders = {
        "BistableWB." + ".".join(path.parent.relative_to(ROOT).parts)
        for name in used
        for path in (ROOT / "resources" / name).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }
    assert listed == ours | folders
    suffixes = {pattern.lstrip("*") for pattern in
                project["tool"]["setuptools"]["package-data"]["*"]}  # fmt: skip
    needed = {
        path.suffix
        for name in used
        for path in (ROOT / "resources" / name).rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }
    assert needed - suffixes <= {".py", ".ts", ".pyc"}  # sources of translations stay at home


def test_a_design_becomes_nets_angles_and_a_report_without_freecad(tmp_path):
    design = read(EXAMPLES / "plane-arch.toml")
    made = {path.suffix: path for path in library.write(design, tmp_path)}
    assert set(made) == {".svg", ".dxf", ".fold", ".csv", ".html"}
    rows = np.genfromtxt(made[".csv"], delimiter=",", names=True)
    fold = json.loads(made[".fold"].read_text())
    assert len(fold["faces_vertices"]) == 11 * len(rows) + 1
    # the file's own corners have the angles of the table
    points = np.array(fold["vertices_coords"])
    edges = points[np.array(fold["edges_vertices"])]
    lengths = np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1)
    assert np.isclose(lengths, design.get("triangles", "edge_length")).sum() >= 2 * len(rows)
    assert f"{rows['theta'][0]:.6f}" in made[".html"].read_text()
    assert np.all((rows["ratio"] > np.sin(np.radians(rows["theta"] / 2))) & (rows["ratio"] < 1))


@pytest.mark.parametrize("name", ["sphere-curve"])
def test_what_needs_freecad_says_so(tmp_path, name):
    with pytest.raises(Refusal, match="needs FreeCAD: install it, and run python3 -m BistableWB"):
        library.write(read(EXAMPLES / f"{name}.toml"), tmp_path)


@pytest.mark.slow
def test_it_works_where_pip_has_put_it(tmp_path):
    if "freecad" in Path(sys.executable).name.lower():
        pytest.skip("asked once, outside FreeCAD")
    home = tmp_path / "venv"
    made = [sys.executable, "-m", "venv", "--system-site-packages", str(home)]
    if subprocess.run(made, capture_output=True, check=False).returncode:
        pytest.skip("no venv here (Debian: apt install python3-venv)")
    copy = tmp_path / "source"  # pip leaves a build folder in what it installs
    subprocess.run(["git", "clone", "-q", str(ROOT), str(copy)], check=True)
    done = subprocess.run(
        [home / "bin/pip", "install", "-q", "--no-deps", "--disable-pip-version-check", copy],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    if done.returncode and "No matching distribution" in done.stderr:
        pytest.skip("no network for setuptools")
    assert done.returncode == 0, done.stderr
    code = """
import json, sys
import BistableWB
from BistableWB.designs.library import main
code = main([str(BistableWB.EXAMPLES / "s-curve.toml"), "--out", sys.argv[1]])
assert (BistableWB.ICONS / "BistableWorkbench.svg").is_file()
print(json.dumps([BistableWB.__file__, code, "FreeCAD" in sys.modules]))
"""
    where, code, with_freecad = run(home / "bin/python", code, tmp_path / "out")
    assert Path(where).is_relative_to(home)
    assert (code, with_freecad) == (0, False)
    assert len(list((tmp_path / "out/s-curve").iterdir())) == 5
