# SPDX-License-Identifier: LGPL-2.1-or-later
"""Hinged prints from a design file: what is made, measured on the files; the demo that shows it."""

import re
import zipfile
from dataclasses import replace

import FreeCAD as App
import Mesh
import numpy as np
import pytest

from BistableWB import EXAMPLES
from BistableWB.designs import building, reading
from BistableWB.objects.bistable_unit import design_of
from BistableWB.origami.design import Thickness
from BistableWB.origami.snap.contact import holding
from BistableWB.origami.snap.margin import assess
from BistableWB.origami.snap.table import USUAL
from BistableWB.pictures import hinge, page
from BistableWB.pictures import prints as prints_page
from BistableWB.program import cli, demo
from BistableWB.reports import print_facts

pytestmark = pytest.mark.slow

UNIT = """
[design]
name = "Print <me>"
[unit]
theta = 50
edge_length = 100
ratio_share = 0.03
[hinges]
segmentations = 3
"""
TUBE = """
[curve]
points = [[0, 0], [60, 30], [120, 15]]
[triangles]
edge_length = 120
gamma = 22
[hinges]
preset = "RecommendedVertex"
gap_length = 0.45
deployment = 1
[output]
pictures = false
formats = ["STL"]
"""
COUPON = """
[coupon]
kind = "vertex"
face_thickness = 1.4
"""


@pytest.fixture(scope="module", autouse=True)
def small_pictures():
    """A ninth of the pixels; test_pictures.py looks at pictures."""
    with pytest.MonkeyPatch.context() as patch:
        for module in (hinge, page, prints_page):
            patch.setattr(module, "DPI", 66)
        patch.setattr(print_facts, "_FINE", (0.1, 0.5))
        yield


@pytest.fixture(scope="module")
def prints(tmp_path_factory):
    """Folder with what the command line makes of three designs, and its exit code."""
    home = tmp_path_factory.mktemp("prints")
    paths = []
    for name, text in (("unit", UNIT), ("tube", TUBE), ("coupon", COUPON)):
        paths.append(home / f"{name}.toml")
        paths[-1].write_text(text, encoding="utf-8")
    return home / "out", cli.main([*map(str, paths), "--out", str(home / "out")])


def names(folder):
    return {path.name for path in folder.iterdir()}


def test_a_print_has_its_files_pictures_and_report(prints):
    out, code = prints
    assert code == 0
    assert names(out / "unit") == {
        "unit.FCStd", "unit-print.stl", "unit-print.3mf", "unit-print.png", "unit-opening.png",
        "unit-hinge.png", "unit-margins.png", "unit-forces.png", "unit-safety.png",
        "unit-energy.png", "unit-slop.png", "report.html",
    }  # fmt: skip
    assert names(out / "tube") == {"tube.FCStd", "tube-print.stl", "report.html"}
    assert names(out / "coupon") == {
        "coupon.FCStd", "coupon-coupon.stl", "coupon-coupon.3mf", "coupon-coupon.png",
        "report.html",
    }  # fmt: skip


@pytest.mark.parametrize("name", ["unit", "tube"])
def test_the_print_is_watertight_and_as_high_as_the_stack(prints, name):
    folder = prints[0] / name
    mesh = Mesh.Mesh(str(folder / f"{name}-print.stl"))
    mesh.removeDuplicatedPoints()
    doc = App.openDocument(str(folder / f"{name}.FCStd"))
    try:
        hinges, unit = doc.getObject("HingeSet"), doc.getObject("BistableUnit")
        thickness, gap = hinges.FaceThickness.Value, hinges.GapBetweenPlanes.Value
        count = len(unit.Alphas)
        assert hinges.Deployment == (name == "tube")
        if unit.Triangles:
            assert unit.Triangles.Thickness.Value == pytest.approx(thickness + gap)
            assert count > 1
        assert mesh.isSolid()
        assert not mesh.hasNonManifolds()
        assert mesh.countComponents() == hinges.BodyCount == 14 * count + 1
        height = count * 4 * (thickness + gap) - gap
        assert mesh.BoundBox.ZLength == pytest.approx(height, abs=1e-3)
        assert mesh.BoundBox.ZMin == pytest.approx(0, abs=1e-3)
    finally:
        App.closeDocument(doc.Name)


def test_the_3mf_names_every_body(prints):
    with zipfile.ZipFile(prints[0] / "unit" / "unit-print.3mf") as package:
        parts = package.read("Metadata/Slic3r_PE_model.config").decode()
    assert len(set(re.findall(r'value="(unit01_\w+)"', parts))) == 15


def test_the_report_tells_numbers_and_what_is_floppy(prints):
    text = (prints[0] / "unit" / "report.html").read_text(encoding="utf-8")
    for part in ("Print &lt;me&gt;", "<dd>15</dd>", "snap margin", "misfit without compensation",
                 "material", "fits the bed", "apart in the flat print"):  # fmt: skip
        assert part in text
    assert "The unit snaps" in text or "The unit is floppy" in text
    assert text.count("data:image/png;base64,") == 8
    assert "Will it snap, will it stand?" in text
    assert text.count('<figure class="live">') == 1


def test_a_floppy_print_is_called_floppy(doc):
    text = UNIT.replace("theta = 50", "theta = 30").replace("share = 0.05", "share = 0.3")
    objects = building.build(doc, reading.check("floppy.toml", text))
    facts = print_facts.HingedTube(objects["hinges"]).facts()
    said = " ".join(str(finding) for finding in facts.findings)
    assert "The unit is floppy" in said
    assert "floppy" in str(facts.rows[0][0])
    assert facts.errors == []


def test_an_error_of_a_check_is_a_failure(tmp_path, monkeypatch, capsys):
    from BistableWB.origami.errors import ERROR, Finding, phrase

    bad = Finding(
        severity=ERROR,
        code="overlap",
        bodies=("a", "b"),
        number=1.0,
        limit=0.0,
        message=phrase("a runs into b."),
        cure=phrase("move it"),
    )
    monkeypatch.setattr(print_facts, "_found", lambda *_: [bad])
    path = tmp_path / "bad.toml"
    path.write_text(UNIT + "[output]\npictures = false\nformats = []\n")
    assert cli.main([str(path), "--out", str(tmp_path / "out")]) == 1
    assert "a runs into b: move it." in capsys.readouterr().err
    report = (tmp_path / "out/bad/report.html").read_text(encoding="utf-8")
    assert '<li class="error">a runs into b: move it.</li>' in report


def test_openscad_is_asked_where_a_design_wants_it(tmp_path, monkeypatch, capsys):
    from BistableWB.origami.errors import ERROR, Finding, phrase
    from BistableWB.programs import openscad

    bad = Finding(
        severity=ERROR,
        code="openscad",
        message=phrase("OpenSCAD finds 14 bodies."),
        cure=phrase("look"),
    )
    asked = []
    monkeypatch.setattr(openscad, "check", lambda meshes: asked.append(len(meshes)) or [bad])
    path = tmp_path / "asked.toml"
    path.write_text(UNIT + "[output]\npictures = false\nformats = []\nopenscad = true\n")
    assert cli.main([str(path), "--out", str(tmp_path / "out")]) == 1
    assert asked == [15]
    assert "OpenSCAD finds 14 bodies: look." in capsys.readouterr().err


def test_the_spherical_example_snaps(doc):
    objects = building.build(doc, reading.read(EXAMPLES / "spherical-unit.toml"))
    hinges = objects["hinges"]
    assert min(hinges.SnapMargins) > 1.5
    assert hinges.DeployedMisfit.Value < 1e-6
    assert np.all(np.array(hinges.PrintSize) < 165)
    assert list(hinges.Warnings) == []


def test_every_unit_of_the_hinged_arch_snaps_and_stays_on_the_curve(doc):
    """Without its solids, which take a while."""
    path = EXAMPLES / "hinged-arch.toml"
    text = re.sub(r"(?s)\[hinges\].*", "", path.read_text(encoding="utf-8"))
    text = text.replace("[triangles]", "[triangles]\nthickness = 1.8")
    objects = building.build(doc, reading.check(path, text))
    parameters = USUAL
    objects["triangles"].Thickness = parameters.pitch
    doc.recompute()
    thickness = Thickness(parameters.face_thickness, parameters.gap_between_planes)
    tube = replace(design_of(objects["unit"]), thickness=thickness).thick()
    snap = assess(tube.thick, holding(tube.thick, parameters))
    assert 6 <= len(snap.margin) <= 10
    assert snap.margin.min() > 1.5
    assert not snap.overstrained.any()
    assert tube.thick.misfit(1.0).max() < 1e-6
    assert tube.deviation() < 1e-3


def test_the_demo_shows_every_example(tmp_path, monkeypatch, capsys):
    arch = "[design]\nname = 'Small'\n[curve]\npoints = [[0, 0], [60, 120], [180, 120], [240, 0]]"
    (tmp_path / "one.toml").write_text(arch + "\n[triangles]\nedge_length = 80\n")
    (tmp_path / "two.toml").write_text("[unit]\ntheta = 45\nedge_length = 60\n")
    monkeypatch.setattr(demo, "EXAMPLES", tmp_path)
    assert demo.main(["--out", str(tmp_path / "out")]) == 0
    assert "Small" in capsys.readouterr().out
    text = (tmp_path / "out/index.html").read_text(encoding="utf-8")
    assert text.count("data:image/png;base64,") == 4
    for link in re.findall(r'href="(?!#)([^"]+)"', text):
        assert (tmp_path / "out" / link).is_file()


def test_pictures_of_the_readme_are_made_from_an_example(tmp_path, monkeypatch, capsys):
    (tmp_path / "two.toml").write_text(UNIT, encoding="utf-8")
    monkeypatch.setattr(demo, "EXAMPLES", tmp_path)
    monkeypatch.setattr(demo, "_README", {"shown.png": ("two", "opening")})
    assert demo.main(["--pictures", str(tmp_path / "out")]) == 0
    assert names(tmp_path / "out") == {"shown.png"}
    assert (tmp_path / "out/shown.png").stat().st_size < 300_000
