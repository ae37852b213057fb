# SPDX-License-Identifier: LGPL-2.1-or-later
"""CalibrationPlate as an object: valid solids, exports, design files, answers for the printer."""

import FreeCAD as App
import pytest

from BistableWB import checking, exporters, make, settings
from BistableWB.designs import building, reading, writing


@pytest.fixture
def plate(doc, valid):
    made = make.make_calibration_plate(doc)
    valid(doc)
    return made


def test_the_plate_is_sound_and_checked_as_what_it_is(plate):
    assert plate.BodyCount == len(plate.Shape.Solids) == 18
    assert all(solid.isValid() for solid in plate.Shape.Solids)
    assert plate.Shape.Volume == pytest.approx(
        sum(body.volume for body in plate.Proxy.bodies(plate)), rel=1e-9
    )
    assert [round(x, 2) for x in plate.Clearances] == [0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5]
    found = checking.check(plate)
    assert not [f for f in found if f.severity == "error"]
    fused = next(f for f in found if f.code == "fused")
    assert fused.bodies[0].startswith("hinge_020")  # that is what the plate is for


def test_a_process_gives_its_numbers_and_leaves_out_what_it_cannot_keep_open(plate, doc, valid):
    plate.Process = "Powder"
    valid(doc)
    assert plate.FaceThickness.Value == 1.5
    assert min(plate.Clearances) == pytest.approx(0.3)
    assert any("Left out, clearance 0.25 mm" in text for text in plate.Warnings)
    assert all(solid.isValid() for solid in plate.Shape.Solids)


def test_the_plate_is_written_by_a_design_file(tmp_path, plate):
    text, _ = writing.text_of({"calibration": plate}, "Plate")
    assert "[calibration]" in text
    design = tmp_path / "plate.toml"
    design.write_text(
        "[calibration]\nleast = 0.3\ncount = 5\nlayer_height = 0.3\nface_thickness = 1.5\n"
        "gap_between_planes = 0.9\n[output]\nformats = ['stl']\npictures = false\n",
        encoding="utf-8",
    )
    made = building.produce(reading.read(design), tmp_path / "out")
    assert made.problems == []
    assert (tmp_path / "out/plate-calibration.stl").exists()
    assert "calibration plate" in (tmp_path / "out/report.html").read_text(encoding="utf-8")


def test_a_dihedral_is_exported_opened_and_a_plate_is_not(tmp_path, doc, plate, valid):
    coupon = make.make_hinge_coupon(doc, preset=None)
    valid(doc)
    for state in ("flat", "deployed"):
        exporters.export([coupon], tmp_path / f"{state}.stl", state=state)
    flat, opened = (tmp_path / f"{state}.stl" for state in ("flat", "deployed"))
    assert flat.read_bytes() != opened.read_bytes()
    with pytest.raises(ValueError, match="cannot be deployed"):
        exporters.export([plate], tmp_path / "plate.stl", state="deployed")


def test_answers_are_the_printers_from_then_on(doc, plate, valid):
    before = settings.number("GapLength"), settings.calibrated_clearance(), settings.air_layers()
    try:
        settings.keep_calibration(0.3, 1)
        assert settings.hinge().gap_length == 0.3  # Auto-fit starts from it
        assert "hinges.GapLength = 0.3" in settings.hinge_lines("hinges")
        assert settings.air_layers() == 1
        settings.keep_calibration(air_layers=settings.NO_AIR)
        assert (settings.calibrated_clearance(), settings.air_layers()) == (0.3, settings.NO_AIR)
        coupon = make.make_hinge_coupon(doc, preset=None)
        coupon.GapLength = 0.25
        valid(doc)
        printer = checking.printer_of(coupon, clearance=settings.calibrated_clearance())
        told = [str(f) for f in checking.check(coupon, printer)]
        assert any("nothing tighter than 0.3 mm turned" in text for text in told)
    finally:
        for name, value in zip(("GapLength", settings.CLEARANCE), before, strict=False):
            settings.group().SetFloat(name, value)
        settings.group().SetInt(settings.AIR_LAYERS, before[2])
    assert App.ActiveDocument is doc
