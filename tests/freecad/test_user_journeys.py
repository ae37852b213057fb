"""What users do that no other test does: prints inside Parts, parts of tubes, wrong words."""

import sys

import FreeCAD as App
import numpy as np
import pytest

from BistableWB import document_report, make
from BistableWB.designs import writing

SHORT = [(0, 0, 0), (40, 60, 0), (90, 60, 0), (130, 0, 0)]
MOVED = App.Placement(App.Vector(10, 20, 100), App.Rotation(App.Vector(1, 0, 0), 90))


@pytest.fixture
def tube(doc):
    """A HingeSet of one unit, the second of a tube of several."""
    curve = make.make_curve(doc, points=SHORT)
    triangles = make.make_triangle_placement(doc, curve, edge_length=60)
    hinges = make.make_hinge_set(doc, make.make_bistable_unit(doc, triangles))
    hinges.FirstUnit = hinges.LastUnit = 2
    return hinges


def middle(hinges):
    """Mean of the bodies' centres of mass, in the object's own frame."""
    return App.Vector(*np.mean([tuple(s.CenterOfMass) for s in hinges.Shape.Solids], 0))


def test_a_part_moves_the_deployed_print_once(doc, tube, valid):
    tube.Deployment = 1
    valid(doc)
    before = middle(tube)
    part = doc.addObject("App::Part", "Part")
    for obj in (tube, *tube.OutListRecursive):
        part.addObject(obj)
    part.Placement = MOVED
    doc.Curve.touch()
    valid(doc)
    assert middle(tube).distanceToPoint(before) < 1e-6
    doc.removeObject("Part")  # what was in it stays, where the curve is again
    doc.Curve.Placement = MOVED
    valid(doc)
    assert middle(tube).distanceToPoint(MOVED.multVec(before)) < 1e-6


def test_a_part_of_a_tube_is_reported(doc, tube, valid, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)  # pictures have tests of their own
    valid(doc)
    text = document_report.write(tube, tmp_path / "part.html").read_text(encoding="utf-8")
    first, second = (text.split(f"<tr><td>{k}</td>")[1].split("</tr>")[0] for k in (1, 2))
    assert "–" in first
    assert "–" not in second
    assert f"{tube.SnapMargins[0]:.2f}" in second


def test_a_design_file_has_round_numbers(doc, tube):
    doc.TrianglePlacement.EdgeLength = "1.5 in"
    text, _ = writing.text_of(writing.objects_of(tube), "Round")
    assert "edge_length = 38.1\n" in text
    assert "thickness = 1.8\n" in text


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda doc: make.make_curve(doc, kind="sphere"), "Kind 'sphere' is unknown"),
        (lambda doc: make.make_hinge_set(doc, None, "rot"), "HingeType 'rot' is unknown"),
        (lambda doc: make.make_hinge_coupon(doc, "Dihedral", "Hing4"), "Preset 'Hing4'"),
    ],
)
def test_a_wrong_word_in_a_macro_leaves_nothing_and_names_the_right_ones(doc, call, said):
    with pytest.raises(ValueError, match=said + ".*: choose one of "):
        call(doc)
    assert not doc.Objects
