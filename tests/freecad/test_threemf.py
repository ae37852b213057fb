# SPDX-License-Identifier: LGPL-2.1-or-later
"""3MF read by others: lib3mf finds the bodies by name, PrusaSlicer prints several materials."""

import re
import shutil
import subprocess
import zipfile

import numpy as np
import pytest

from BistableWB import make
from BistableWB.exporters import export, threemf

CONFIG = """printer_technology = FFF
gcode_flavor = marlin
nozzle_diameter = 0.4,0.4
filament_diameter = 1.75,1.75
extruder_offset = 0x0,0x0
temperature = 200,210
first_layer_temperature = 200,210
layer_height = 0.2
first_layer_height = 0.2
fill_density = 100%
fill_pattern = rectilinear
skirts = 0
"""


@pytest.fixture
def soft(doc, valid):
    """A dihedral with a flexible strip."""
    coupon = make.make_hinge_coupon(doc)
    coupon.HingeType = "Flexible"
    coupon.LengthX, coupon.LengthY, coupon.LayerHeight = 20, 15, 0.2
    valid(doc)
    return coupon


@pytest.fixture
def supported(doc, valid):
    """One unit with its soluble support."""
    unit = make.make_bistable_unit(doc, theta=45, ratio=0.42, edge_length=40)
    hinges = make.make_hinge_set(doc, unit)
    hinges.Segmentations, hinges.Support = 3, True
    valid(doc)
    return hinges


def test_every_material_has_an_extruder():
    names = ["unit01_border_left", "support", "strip_crease", "unit01_link_B"]
    assert threemf.extruders_for(names) == [1, 3, 2, 1]
    assert threemf.extruders_for(names[:2]) == [1, 2]
    assert threemf.extruders_for(names[:1]) == [1]


def slicer_file(path):
    with zipfile.ZipFile(path) as package:
        names = package.namelist()
        config = [name for name in names if name.startswith("Metadata")]
        return package.read(config[0]).decode() if config else None


def test_prints_of_one_material_are_assemblies_unless_asked_otherwise(doc, valid, soft, tmp_path):
    plain = make.make_hinge_coupon(doc)
    valid(doc)
    assert slicer_file(export(plain, tmp_path / "a.3mf")) is None
    assert slicer_file(export(soft, tmp_path / "a.3mf", one_object=False)) is None
    one = slicer_file(export(plain, tmp_path / "a.3mf", one_object=True))
    assert re.findall(r'key="extruder" value="(\d)"', one) == ["1", "1"]
    several = slicer_file(export(soft, tmp_path / "a.3mf"))
    assert re.findall(r'key="extruder" value="(\d)"', several) == ["1", "1", "2"]
    assert re.findall(r'volume" key="name" value="(\w+)"', several) == list(soft.BodyNames)


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("prusa-slicer"), reason="needs prusa-slicer")
@pytest.mark.parametrize("kind", ["soft", "supported"])
def test_prusa_slicer_prints_each_material_with_its_extruder(kind, request, tmp_path):
    obj = request.getfixturevalue(kind)
    path = export(obj, tmp_path / "print.3mf")
    (tmp_path / "two.ini").write_text(CONFIG)
    subprocess.run(
        ["prusa-slicer", "--load", "two.ini", "-g", path.name, "-o", "print.gcode"],
        cwd=tmp_path, capture_output=True, timeout=300, check=True,
    )  # fmt: skip
    text = (tmp_path / "print.gcode").read_text()
    assert set(re.findall(r"^T(\d)", text, re.MULTILINE)) == {"0", "1"}
    used = re.search(r"; filament used \[cm3\] = (.*)", text).group(1)
    printed = np.array(used.split(","), float)[:2] * 1000
    volumes = np.zeros(2)
    for name, shape in obj.Proxy.export_bodies(obj):
        volumes[threemf.extruders_for(["panel", name])[1] - 1] += shape.Volume
    assert printed == pytest.approx(volumes, rel=0.2)
    # nothing was pulled apart on the bed
    moves = re.findall(r"^G1 X([\d.]+) Y([\d.]+) E", text, re.MULTILINE)
    extent = np.ptp(np.array(moves, float), axis=0)
    assert extent == pytest.approx(tuple(obj.PrintSize)[:2], abs=1.5)


@pytest.mark.slow
def test_lib3mf_reads_the_bodies_by_name(soft, supported, tmp_path):
    lib3mf = pytest.importorskip("lib3mf")
    wrapper = lib3mf.get_wrapper()
    for obj in (soft, supported):
        for one in (False, True):
            path = export(obj, tmp_path / "a.3mf", one_object=one)
            model = wrapper.CreateModel()
            reader = model.QueryReader("3mf")
            reader.SetStrictModeActive(True)
            reader.ReadFromFile(str(path))
            assert reader.GetWarningCount() == 0
            bodies = dict(obj.Proxy.export_bodies(obj))
            meshes = _each(model.GetMeshObjects(), "GetCurrentMeshObject")
            assert all(mesh.IsManifoldAndOriented() for mesh in meshes)
            if one:
                (mesh,) = meshes
                assert mesh.GetName() == "a"
                continue
            parts = _each(model.GetComponentsObjects(), "GetCurrentComponentsObject")
            named = {o.GetName() for o in (*meshes, *parts)} - {"", "a"}
            assert named == set(bodies)
            assert model.GetUnit() == lib3mf.ModelUnit.MilliMeter


def _each(iterator, current):
    found = []
    while iterator.MoveNext():
        found.append(getattr(iterator, current)())
    return found
