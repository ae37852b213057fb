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
from tests.judges import judge

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
    kinds = ["border", "support", "flexure", "link"]
    assert threemf.extruders_for(kinds) == [1, 3, 2, 1]
    assert threemf.extruders_for(kinds[:2]) == [1, 2]
    assert threemf.extruders_for(kinds[:1]) == [1]


def test_a_name_does_not_choose_the_material(doc, tmp_path):
    """A box of the user's is printed in what panels are made of, whatever its label says."""
    for label in ("Support bracket", "strip", "flexure"):
        box = doc.addObject("Part::Box", "Box")
        box.Label = label
    doc.recompute()
    path = export(doc.Objects, tmp_path / "a.3mf")
    assert set(re.findall(r'key="extruder" value="(\d)"', slicer_file(path))) == {"1"}
    with zipfile.ZipFile(path) as package:
        model = package.read("3D/3dmodel.model").decode()
    looks = re.findall(r'<base name="(\w+)"', model)
    assert {looks[int(k)] for k in re.findall(r'p(?:index|1)="(\d+)"', model)} == {"other"}


def slicer_file(path):
    with zipfile.ZipFile(path) as package:
        names = package.namelist()
        config = [name for name in names if name.startswith("Metadata")]
        return package.read(config[0]).decode() if config else None


def test_a_print_is_one_object_unless_asked_otherwise(doc, valid, soft, tmp_path):
    plain = make.make_hinge_coupon(doc)
    valid(doc)
    assert slicer_file(export(plain, tmp_path / "a.3mf", assembly=True)) is None
    assert slicer_file(export(soft, tmp_path / "a.3mf", one_object=False)) is None  # as of 0.1.0
    one = slicer_file(export(plain, tmp_path / "a.3mf"))
    assert re.findall(r'key="extruder" value="(\d)"', one) == ["1", "1"]
    several = slicer_file(export(soft, tmp_path / "a.3mf"))
    assert re.findall(r'key="extruder" value="(\d)"', several) == ["1", "1", "2"]
    assert re.findall(r'volume" key="name" value="(\w+)"', several) == list(soft.BodyNames)


COARSE = ["--layer-height", "0.2", "--first-layer-height", "0.2", "--fill-density", "0"]
SLICERS = {
    "prusa-slicer": ["prusa-slicer", "-g", *COARSE],
    "slic3r": ["slic3r", *COARSE],
}


@pytest.mark.slow
@pytest.mark.parametrize("slicer", SLICERS)
def test_slicers_print_the_stack_as_one_object_of_its_height(slicer, doc, valid, tmp_path):
    if not shutil.which(slicer):
        pytest.skip(f"needs {slicer}")
    unit = make.make_bistable_unit(doc, theta=45, ratio=0.42, edge_length=45)
    hinges = make.make_hinge_set(doc, unit)
    valid(doc)
    path = export(hinges, tmp_path / "print.3mf")
    subprocess.run(
        [*SLICERS[slicer], path.name, "-o", "print.gcode"],
        cwd=tmp_path, capture_output=True, timeout=300, check=True,
    )  # fmt: skip
    text = (tmp_path / "print.gcode").read_text()
    heights = np.array(re.findall(r"^G1 Z([\d.]+)", text, re.MULTILINE), float)
    deposits = re.findall(r"^G1 X([\d.]+) Y([\d.]+) E", text, re.MULTILINE)
    printed = len(re.findall(r"^;LAYER_CHANGE", text, re.MULTILINE)) or len(np.unique(heights))
    assert printed * 0.2 == pytest.approx(hinges.PrintSize.z, abs=0.41)
    extent = np.ptp(np.array(deposits, float), axis=0)
    skirt = 16  # mm that a skirt may lie outside
    assert (extent < np.array(tuple(hinges.PrintSize)[:2]) + skirt).all()


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
    for _, shape, kind in obj.Proxy.export_bodies(obj):
        volumes[threemf.extruders_for(["contact", kind])[1] - 1] += shape.Volume
    assert printed == pytest.approx(volumes, rel=0.2)
    # nothing was pulled apart on the bed
    moves = re.findall(r"^G1 X([\d.]+) Y([\d.]+) E", text, re.MULTILINE)
    extent = np.ptp(np.array(moves, float), axis=0)
    assert extent == pytest.approx(tuple(obj.PrintSize)[:2], abs=1.5)


@pytest.mark.slow
def test_lib3mf_reads_the_bodies_by_name(soft, supported, tmp_path):
    lib3mf = judge("lib3mf")
    wrapper = lib3mf.get_wrapper()
    for obj in (soft, supported):
        for one in (False, True):
            path = export(obj, tmp_path / "a.3mf", assembly=not one)
            model = wrapper.CreateModel()
            reader = model.QueryReader("3mf")
            reader.SetStrictModeActive(True)
            reader.ReadFromFile(str(path))
            assert reader.GetWarningCount() == 0
            bodies = {name for name, _, _ in obj.Proxy.export_bodies(obj)}
            meshes = _each(model.GetMeshObjects(), "GetCurrentMeshObject")
            assert all(mesh.IsManifoldAndOriented() for mesh in meshes)
            if one:
                (mesh,) = meshes
                assert mesh.GetName() == "a"
                continue
            parts = _each(model.GetComponentsObjects(), "GetCurrentComponentsObject")
            named = {o.GetName() for o in (*meshes, *parts)} - {"", "a"}
            assert named == bodies
            assert model.GetUnit() == lib3mf.ModelUnit.MilliMeter


def _each(iterator, current):
    found = []
    while iterator.MoveNext():
        found.append(getattr(iterator, current)())
    return found
