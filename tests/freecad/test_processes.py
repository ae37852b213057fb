# SPDX-License-Identifier: LGPL-2.1-or-later
"""Process: what it sets, what a user sets after it, and what older files and design files keep."""

import FreeCAD as App
import pytest

from BistableWB import checking, make
from BistableWB.designs import building, reading
from BistableWB.objects.hinge_inputs import hinge_parameters
from BistableWB.origami.errors import ERROR
from BistableWB.origami.hinges.processes import PROCESSES, SOLUBLE, STANDOFFS

DESIGN = """
[unit]
theta = 50
edge_length = 90

[hinges]
face_thickness = 2.0
process = "Powder"
gap_length = 0.6
"""


@pytest.mark.parametrize("name", PROCESSES)
def test_a_process_sets_what_suits_it(doc, unit, name):
    hinges = make.make_hinge_set(doc, unit)
    assert hinges.Process == STANDOFFS
    hinges.Process = name
    given = hinge_parameters(hinges)
    for field, value in PROCESSES[name].gives.items():
        assert getattr(given, field) == pytest.approx(value), field
    assert hinges.Orientation == PROCESSES[name].orientation
    assert hinges.Material == PROCESSES[name].material
    hinges.GapLength = 0.45
    assert hinge_parameters(hinges).gap_length == pytest.approx(0.45)


def test_a_file_from_before_there_was_a_process_keeps_its_numbers(doc, unit, valid, tmp_path):
    hinges = make.make_hinge_set(doc, unit)
    hinges.GapLength, hinges.Orientation, hinges.Material = 0.5, "OnEdge", "PETG"
    valid(doc)
    hinges.removeProperty("Process")
    path = tmp_path / "old.FCStd"
    doc.saveAs(str(path))
    App.closeDocument(doc.Name)
    again = App.openDocument(str(path))
    old = again.getObject("HingeSet")
    assert old.Process == SOLUBLE
    assert (old.GapLength.Value, old.Orientation, old.Material) == (0.5, "OnEdge", "PETG")
    App.closeDocument(again.Name)


def test_keys_of_a_design_file_go_before_what_its_process_gives(doc, tmp_path):
    path = tmp_path / "powder.toml"
    path.write_text(DESIGN, encoding="utf-8")
    hinges = building.build(doc, reading.read(path))["hinges"]
    assert hinges.Process == "Powder"
    assert hinges.GapLength.Value == pytest.approx(0.6)
    assert hinges.FaceThickness.Value == pytest.approx(2.0)
    assert hinges.GapBetweenPlanes.Value == pytest.approx(0.7)


FINE = """
[unit]
theta = 55
ratio_rule = "Fixed"
ratio = 0.5
edge_length = 40

[hinges]
layer_height = 0.05
nozzle_diameter = 0.2
face_thickness = 0.8
gap_between_planes = 0.2
gap_length = 0.2
"""


def test_a_fine_print_passes_its_checks(doc, valid, tmp_path):
    path = tmp_path / "fine.toml"
    path.write_text(FINE, encoding="utf-8")
    hinges = building.build(doc, reading.read(path))["hinges"]
    valid(doc)
    given = hinge_parameters(hinges).standoffs
    assert given.air_layers * 0.05 == pytest.approx(0.15)
    found = {finding.code: finding for finding in checking.check(hinges)}
    assert not [f for f in found.values() if f.severity == ERROR]
    assert "island" not in found
    assert found["fused"].number == 0


def test_ribs_are_drawn_by_the_kernel_and_can_be_left_out(doc, unit, valid):
    hinges = make.make_hinge_set(doc, unit)
    valid(doc)
    ribbed = hinges.Proxy.model(hinges).bodies
    assert all(body.shape.isValid() for body in ribbed)
    for body in ribbed:
        assert body.shape.Volume == pytest.approx(body.boundary.volume, rel=1e-9)
    hinges.Process = SOLUBLE
    valid(doc)
    plain = hinges.Proxy.model(hinges).bodies
    assert sum(b.volume for b in ribbed) > 1.03 * sum(b.volume for b in plain)


def test_ribs_too_far_apart_are_refused(doc, unit, refused):
    hinges = make.make_hinge_set(doc, unit)
    hinges.StandOffSpacing = 20
    assert "a printer spans 10 mm" in refused(doc, hinges)
