# SPDX-License-Identifier: LGPL-2.1-or-later
"""All checks of a print in a document: silent on a good one, each loud on one that is not."""

import pytest

from BistableWB import checking, make
from BistableWB.checks import ERROR, NOTE, WARNING
from BistableWB.checks.printer import Printer
from BistableWB.checks.printing import Print
from BistableWB.origami.hinges.bed import Bed
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.solids.tessellation import placed_meshes


@pytest.fixture
def hinged(doc, valid):
    """``hinged(**properties)``: HingeSet of one unit, firm by default, three knuckles a hinge."""

    def make_one(edge_length=100.0, ratio=0.393, **properties):
        unit = make.make_bistable_unit(doc, theta=45, ratio=ratio, edge_length=edge_length)
        obj = make.make_hinge_set(doc, unit, process="FDM, soluble")
        for name, value in {"Segmentations": 3, "Preload": 0, **properties}.items():
            setattr(obj, name, value)
        valid(doc)
        return obj

    return make_one


def by_code(findings):
    return {finding.code: finding for finding in findings}


def some(obj, *codes, printer=None):
    """{code: finding} of some steps of the checks."""
    bodies = checking.bodies_of(obj)
    steps = dict(checking.suite_of(obj, bodies, placed_meshes(bodies), printer).steps())
    return by_code(finding for code in codes for finding in steps[code]())


def test_the_recommended_print_has_nothing_but_notes(hinged):
    found = checking.check(hinged(Support=True))
    assert [str(finding) for finding in found if finding.severity != NOTE] == []
    codes = [finding.code for finding in found]
    assert codes == ["bed", "snap", "clearance", "layers", "fused", "overhang", "wall", "cone",
                     *["overlap"] * 4]  # fmt: skip
    numbers = by_code(found)
    assert numbers["cone"].number == pytest.approx(55, abs=3)
    assert numbers["fused"].number < 0.15
    assert numbers["layers"].number == pytest.approx(1, abs=0.05)


def test_preloaded_bodies_press_as_deep_as_their_preload_and_no_deeper(hinged):
    obj = hinged(SegmentWidth=5, PreloadRule="Automatic")
    pressed = obj.Proxy.model(obj).tube.thick.rest.pressed.max()
    assert 0.05 < pressed < 0.15
    found = some(obj, "overlaps 100%")["overlap"]
    assert found.severity == NOTE
    assert 0.5 * pressed < found.number < 2 * pressed
    assert "preload" in str(found.message)
    assert some(obj, "clearances")["clearance"].severity == NOTE  # flat, nothing presses


def test_without_support_it_says_what_hangs_over_air(hinged):
    obj = hinged()
    hanging = some(obj, "layers")["overhang"]
    assert hanging.severity == WARNING
    assert "Support" in str(hanging.cure)
    # the largest panel lies over the gap
    areas = [max(face.Area for face in solid.Faces) for solid in obj.Shape.Solids]
    assert 0.7 * max(areas) < hanging.number < max(areas)
    assert hanging.bodies[0] in obj.BodyNames


def test_a_layer_higher_than_the_gaps_welds_the_print(hinged):
    coarse = some(hinged(Support=True), "layers", printer=Printer(layer_height=0.7))
    fused = coarse["fused"]
    assert fused.severity == ERROR
    assert fused.number > 1
    assert len(fused.bodies) == 2
    assert coarse["layers"].severity == WARNING


def test_a_nozzle_wider_than_the_walls(hinged):
    wall = some(hinged(), "walls", printer=Printer(nozzle_diameter=0.8))["wall"]
    assert wall.severity == ERROR
    assert wall.number == pytest.approx(0.4, abs=0.05)  # what the hinge was made for
    assert wall.points


def test_cones_that_are_too_steep(hinged, monkeypatch):
    monkeypatch.setattr(HingeParameters, "check", lambda self: None)  # it would refuse them
    cone = some(hinged(ConeAngle=70, FaceThickness=1.6), "walls")["cone"]
    assert cone.severity == WARNING
    assert cone.number == pytest.approx(70, abs=3)
    assert "ConeAngle" in str(cone.cure)


def test_an_uncompensated_print_is_told_to_compensate(hinged):
    overlap = some(hinged(edge_length=60.0, Compensate=False), "overlaps 100%")["overlap"]
    assert overlap.severity == ERROR
    assert str(overlap.cure) == "switch Compensate on, so that the hinges close"
    assert overlap.opening == 1


def test_what_was_found_once_is_not_looked_for_again(doc, hinged, monkeypatch):
    obj, asked = hinged(), []
    look = Print.check_flat
    monkeypatch.setattr(Print, "check_flat", lambda *given: asked.append(1) or look(*given))
    first = some(obj, "clearances")
    assert some(obj, "clearances") == first
    assert len(asked) == 1
    some(obj, "clearances", printer=Printer(resolution=0.3))
    assert len(asked) == 2
    obj.GapLength = 0.5
    doc.recompute()
    some(obj, "clearances")
    assert len(asked) == 3


def test_on_edge_the_print_stands_and_its_bed_is_checked(doc, hinged, refused):
    obj = hinged(Orientation="OnEdge")
    found = some(obj, "size", "layers")
    size = obj.PrintSize
    assert found["bed"].number == pytest.approx(size.z, rel=0.1)
    assert size.z > 90
    assert found["island"].severity == WARNING
    assert "slicer" in str(found["island"].cure)
    low = Printer(bed=Bed(height=50))
    assert some(obj, "size", printer=low)["bed"].severity == ERROR
    obj.Bed = (250, 210, 50)
    assert "Not even one unit" in refused(doc, obj)
    obj.Orientation = "Flat"
    doc.recompute()
    assert obj.isValid()


def test_floppy_units_are_named(hinged):
    snap = some(hinged(edge_length=40.0, ratio=0.5), "snap")["snap"]
    assert snap.severity == WARNING
    assert snap.bodies == ("unit01",)
    assert "floppy" in str(snap.message)
    assert "EdgeLength" in str(snap.cure)


@pytest.mark.parametrize(
    ("kind", "preset"), [("Dihedral", "Recommended"), ("Vertex", "RecommendedVertex")]
)
def test_recommended_coupons_pass_at_fine_layers(doc, valid, kind, preset):
    coupon = make.make_hinge_coupon(doc)
    coupon.Kind, coupon.Preset, coupon.LayerHeight = kind, preset, 0.2
    valid(doc)
    found = checking.check(coupon)
    assert {f.severity for f in found if f.code != "overhang"} == {NOTE}
    thick = some(coupon, "layers", printer=Printer(layer_height=0.9))
    assert thick["fused"].severity == ERROR
