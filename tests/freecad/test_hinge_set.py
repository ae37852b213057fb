"""HingeSet: parametric, valid solids, cheap Deployment, warnings and refusals."""

import math
import re

import FreeCAD as App
import pytest

from BistableWB import make
from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.hinges.parameters import HingeParameters
from BistableWB.origami.thick.thick_tube import thick_tube
from BistableWB.origami.units.ratios import RatioRule
from BistableWB.origami.units.tube import along
from BistableWB.solids.tube import tube_bodies

PITCH, GAP = 1.8, 0.6
SHORT = [(0, 0, 0), (40, 60, 0), (90, 60, 0), (130, 0, 0)]


@pytest.fixture
def tube(doc, valid):
    """A short tube of a few thick units."""
    curve = make.make_curve(doc, points=SHORT)
    triangles = make.make_triangle_placement(doc, curve, edge_length=60)
    unit = make.make_bistable_unit(doc, triangles)
    hinges = make.make_hinge_set(doc, unit)
    valid(doc)
    return triangles, unit, hinges


def single(doc, **options):
    unit = make.make_bistable_unit(doc, theta=45, ratio=0.42, edge_length=60)
    for name, value in options.items():
        setattr(unit, name, value)
    return unit, make.make_hinge_set(doc, unit)


def test_whole_tube_in_one_stack(doc, tube):
    triangles, _, hinges = tube
    n = triangles.Count
    assert triangles.Thickness.Value == pytest.approx(PITCH)
    assert n >= 3
    assert hinges.BodyCount == 15 * n - (n - 1) == len(hinges.Shape.Solids)
    assert len(set(hinges.BodyNames)) == hinges.BodyCount
    assert hinges.PrintSize.z == pytest.approx(n * 4 * PITCH - GAP, abs=1e-6)
    assert hinges.Shape.BoundBox.ZMin == pytest.approx(0, abs=1e-6)
    assert all(solid.isValid() and solid.isClosed() for solid in hinges.Shape.Solids)
    assert hinges.DeployedMisfit.Value < 1e-6
    assert hinges.CurveDeviation.Value < 1e-3


def test_deployment_moves_the_same_solids(doc, tube, valid):
    _, _, hinges = tube
    model = hinges.Proxy.model(hinges)
    volumes = [solid.Volume for solid in hinges.Shape.Solids]
    hinges.Deployment = 1
    valid(doc)
    assert hinges.Proxy.model(hinges) is model  # nothing was made again
    assert [s.Volume for s in hinges.Shape.Solids] == pytest.approx(volumes, rel=1e-9)
    assert hinges.DeployedSize.x > 100
    hinges.Deployment = 0.4
    valid(doc)
    assert hinges.Proxy.model(hinges) is model


def test_deployed_tube_stands_on_its_zero_thickness_faces(doc, tube, valid):
    _, unit, hinges = tube
    hinges.Deployment = 1
    valid(doc)
    thin, thick = unit.Shape.BoundBox, hinges.Shape.BoundBox
    for name in ("XMin", "YMin", "ZMin"):
        assert getattr(thick, name) < getattr(thin, name) + 4
        assert getattr(thick, name) > getattr(thin, name) - 8


def test_upstream_change_makes_it_anew(doc, tube, valid):
    triangles, _, hinges = tube
    before = hinges.BodyCount
    triangles.EdgeLength = 75
    valid(doc)
    assert hinges.BodyCount != before
    assert hinges.BodyCount == 15 * triangles.Count - (triangles.Count - 1)


def test_on_edge_stands_on_the_bed(doc, tube, valid):
    _, _, hinges = tube
    flat = hinges.PrintSize
    hinges.Orientation = "OnEdge"
    valid(doc)
    assert hinges.Shape.BoundBox.ZMin == pytest.approx(0, abs=1e-6)
    assert sorted(hinges.PrintSize) == pytest.approx(sorted(flat), abs=1e-6)
    assert hinges.PrintSize.x == pytest.approx(flat.z)


def test_single_spherical_unit(doc, valid):
    _, hinges = single(doc, Omega=80, RatioRule="Exact")
    valid(doc)
    assert hinges.BodyCount == 15
    assert hinges.DeployedMisfit.Value < 1e-6
    hinges.Deployment = 1
    valid(doc)


def test_without_compensation_it_does_not_close(doc, valid):
    _, hinges = single(doc)
    hinges.Compensate = False
    valid(doc)
    assert hinges.DeployedMisfit.Value > 0.3


def test_thickness_missing_in_the_placement_is_a_warning_with_a_cure(doc, tube, valid):
    triangles, unit, hinges = tube
    unit.RatioRule = "Adaptive"  # TargetSnap refuses, with the same cure
    triangles.Thickness = 0
    valid(doc)
    assert any("set Thickness of" in w and "1.8 mm" in w for w in hinges.Warnings)
    triangles.Thickness = PITCH
    valid(doc)
    assert not any("strays" in w for w in hinges.Warnings)


def test_preset_of_the_paper(doc, valid):
    unit = make.make_bistable_unit(doc, theta=45, ratio=0.42, edge_length=60)
    hinges = make.make_hinge_set(doc, unit, preset="Hinge9")
    assert hinges.Segmentations == 5
    assert hinges.GapBetweenPlanes.Value == pytest.approx(0.6)
    with pytest.raises(ValueError, match="Preset 'Hinge0' is unknown"):
        make.make_hinge_set(doc, unit, preset="Hinge0")


CASES = [
    ({"Unit": None}, "Unit is empty: choose"),
    ({"Segmentations": 4}, "Segmentations is 4.*odd"),
    ({"Segmentations": 1}, "Segmentations is 1.*3"),
    ({"GapLength": 0.1}, "GapLength.*below the layer height"),
    ({"GapBetweenPlanes": 0.1}, "GapBetweenPlanes.*below the layer height"),
    ({"FaceThickness": 0}, "FaceThickness is 0"),
    ({"FaceThickness": 0.5}, "cones.*FaceThickness"),
    ({"Pivot": "Pin", "NozzleDiameter": 0.6}, "pin|wall"),
    ({"ConeAngle": 30}, "ConeAngle is 30.*45"),
    ({"LayerHeight": 0}, "LayerHeight is 0"),
    ({"Deployment": float("nan")}, "Deployment is nan"),
]


@pytest.mark.parametrize(("values", "words"), CASES)
def test_refusal_and_recovery(doc, valid, refused, values, words):
    _, hinges = single(doc)
    valid(doc)
    before = {key: getattr(hinges, key) for key in values}
    for key, value in values.items():
        setattr(hinges, key, value)
    sentence = refused(doc, hinges)
    assert re.search(words, sentence), sentence
    assert len(hinges.Shape.Solids) == 15  # nothing is lost
    for key, value in before.items():
        setattr(hinges, key, value)
    valid(doc)


def test_unit_too_small_for_the_hinge_is_named(doc, refused):
    unit, hinges = single(doc)
    unit.EdgeLength = 16
    assert re.search("EdgeLength|HeightRatio|Segmentations", refused(doc, hinges))


def test_layer_quantisation_is_a_warning_with_the_nearest_values(doc, valid):
    _, hinges = single(doc)
    hinges.FaceThickness, hinges.LayerHeight = 1.25, 0.3
    valid(doc)
    assert any("1.2 or 1.5 mm" in w for w in hinges.Warnings)


def test_saved_and_reopened(doc, valid, tmp_path):
    _, hinges = single(doc)
    valid(doc)
    path = tmp_path / "hinges.FCStd"
    doc.saveAs(str(path))
    App.closeDocument(doc.Name)
    again = App.openDocument(str(path))
    hinges = again.getObject("HingeSet")
    assert len(hinges.Shape.Solids) == 15
    hinges.Deployment = 1
    valid(again)
    assert hinges.DeployedSize.y > 40
    App.closeDocument(again.Name)


def test_part_of_a_tube_has_half_blocks_at_its_cuts(doc, tube, valid):
    hinges = tube[2]
    whole = hinges.BodyCount
    hinges.LastUnit = 2
    valid(doc)
    assert hinges.BodyCount == 2 * 15 - 1
    assert sum(name.startswith("half_") for name in hinges.BodyNames) == 1
    assert hinges.PrintSize.z == pytest.approx(2 * 4 * PITCH - GAP / 2, abs=1e-6)
    hinges.FirstUnit, hinges.LastUnit = 2, 0
    valid(doc)
    assert hinges.BodyCount == whole - 14
    assert hinges.Shape.BoundBox.ZMin == pytest.approx(0, abs=1e-6)
    hinges.Deployment = 1
    valid(doc)
    assert hinges.CurveDeviation.Value < 1e-3


def test_print_too_large_for_the_bed_names_the_parts(doc, tube, refused, valid):
    triangles, _, hinges = tube
    hinges.Bed = App.Vector(200, 200, 16)
    sentence = refused(doc, hinges)
    assert re.search(r"too large for the bed of 200 × 200 × 16 mm: 2 units fit", sentence)
    assert f"parts 1–2, 3–{min(4, triangles.Count)}" in sentence
    hinges.LastUnit = 2
    valid(doc)
    hinges.Bed = App.Vector(30, 30, 100)
    assert "Not even one unit" in refused(doc, hinges)


@pytest.mark.parametrize("units", [(0, 0), (3, 2), (1, 99), (-1, 2)])
def test_range_of_units_that_are_not_there(doc, tube, refused, units):
    hinges = tube[2]
    hinges.FirstUnit, hinges.LastUnit = units
    assert "FirstUnit" in refused(doc, hinges)


def test_axes_almost_parallel_close(doc):
    """Compensation may leave an axis 1e-7 off a panel's edge, which OCC cannot sew as it is."""
    curve = Bezier([(0, 0), (200, 900), (1000, 900), (1200, 0)])
    tube = thick_tube(
        lambda tuning: place(curve, 60, math.radians(20), PITCH, extra=tuning.extra),
        lambda placed, tuning: along(placed, "Plane", 2.5, RatioRule(share=0.03), tuning=tuning),
        1.2,
        GAP,
    )
    for k in (11, 59):
        assert len(tube_bodies(tube.thick[k : k + 1], HingeParameters())) == 15


def test_every_input_of_the_unit_makes_it_anew(doc, valid):
    unit, hinges = single(doc)
    unit.Thickness = PITCH
    unit.RatioRule = "TargetSnap"
    valid(doc)
    models = [hinges.Proxy.model(hinges)]
    for name, value in (("TargetMargin", 1.2), ("HingePlay", 0.3), ("HeightRatio", 2.2)):
        setattr(unit, name, value)
        valid(doc)
        models.append(hinges.Proxy.model(hinges))
    assert len({id(model) for model in models}) == len(models)
