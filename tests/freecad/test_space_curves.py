# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tubes along any space curve go all the way: firm by default, printed, standing on their curve."""

import FreeCAD as App
import numpy as np
import pytest

from BistableWB import make
from BistableWB.checks import ERROR
from BistableWB.checks.printing import Print
from BistableWB.objects.curve import geometry_of
from BistableWB.solids.tessellation import placed_meshes

RISE = [(0, 0, 0), (33, 66, 6), (84, 96, 13), (133, 89, 20)]
SEEN = [(-110, -30, 0), (-72, 25, 16), (-24, 50, 30), (23, 44, 32)]


def printed(doc, viewpoint):
    curve = make.make_curve(doc, points=SEEN if viewpoint else RISE, kind="General")
    if viewpoint:
        curve.RulingKind, curve.Ruling = "Viewpoint", App.Vector(*viewpoint)
    else:
        curve.Ruling = App.Vector(0, 0, 1)
    triangles = make.make_triangle_placement(doc, curve, edge_length=75, gamma=30)
    unit = make.make_bistable_unit(doc, triangles)
    return curve, triangles, unit, make.make_hinge_set(doc, unit)


@pytest.fixture(params=[(0, 0, -200), None], ids=["viewpoint", "parallel"])
def chain(request, doc, valid):
    """Curve, triangles, unit and print of a short tube, by defaults."""
    made = printed(doc, request.param)
    valid(doc)
    return made


def middle_plane(block):
    """Mid-plane of a block's solid, half way between its two largest faces: height, unit normal."""
    first, second = sorted(block.Faces, key=lambda face: -face.Area)[:2]
    normal = np.array(first.normalAt(0, 0))
    heights = [float(np.array(face.CenterOfMass) @ normal) for face in (first, second)]
    assert abs(heights[0] - heights[1]) == pytest.approx(2 * 1.2 + 0.6, abs=1e-6)
    return sum(heights) / 2, normal


def test_a_space_curve_is_firm_by_default_and_its_solids_stand_on_it(doc, chain):
    """Flat nothing touches; deployed the *solids* stand on the curve, and nothing overlaps."""
    curve, triangles, unit, hinges = chain
    assert (hinges.Process, hinges.PreloadRule) == ("FDM, stand-offs", "Automatic")
    assert min(hinges.SnapMargins) >= 1.3
    # Nothing pressed: what a preload presses at rest would be an overlap here, and hide others.
    # Bare, as solids are looked at; stand-offs: tests/origami/test_standoffs.py.
    hinges.Process, hinges.Preload = "FDM, soluble", 0
    doc.recompute()
    assert unit.RatioRule == "TargetSnap"
    assert triangles.Count >= 3
    assert unit.IsometryError <= 1e-12
    assert min(hinges.SnapMargins) >= 1.3
    assert not any("floppy" in text for text in unit.Warnings)  # one misses the aim of 1.8, firmly
    assert hinges.DeployedMisfit.Value < 1e-6
    assert hinges.BodyCount == 14 * triangles.Count + 1 == len(hinges.Shape.Solids)
    model = hinges.Proxy.model(hinges)
    whole = Print(placed_meshes(model.bodies), model.parameters)
    assert whole.check_soundness([body.shape.Volume for body in model.bodies]) == []
    found = [*whole.check_flat(), *whole.check_poses(model.tube.motions(1.0), 1.0)]
    assert [str(finding) for finding in found if finding.severity == ERROR] == []

    points = np.asarray(geometry_of(curve).curve.point(np.linspace(0, 1, 4001)), float)
    blocks = [s for b, s in zip(model.bodies, model.shapes(1), strict=True) if len(b.members) == 2]
    assert len(blocks) == triangles.Count - 1
    for k, block in enumerate(blocks, 1):
        height, normal = middle_plane(block)
        midpoint = model.tube.placement.midpoints[k]
        assert np.linalg.norm(points - midpoint, axis=1).min() < 0.1
        assert midpoint @ normal == pytest.approx(height, abs=2e-3)
        assert normal @ model.tube.placement.legs[k] == pytest.approx(0, abs=1e-5)
        assert normal @ model.tube.placement.reaches[k] == pytest.approx(0, abs=1e-3)


def test_a_rule_that_somebody_chose_stays(doc):
    curve = make.make_curve(doc, points=RISE, kind="General")
    unit = make.make_bistable_unit(doc, make.make_triangle_placement(doc, curve, 75, 30))
    unit.RatioShare = 0.1
    hinges = make.make_hinge_set(doc, unit)
    assert (unit.RatioRule, unit.RatioShare) == ("Adaptive", 0.1)
    assert unit.HingePlay.Value == pytest.approx(0.28, abs=1e-3)
    assert hinges.Unit == unit


def test_floppy_units_say_so_without_a_print(doc, valid, capfd):
    curve = make.make_curve(doc)
    triangles = make.make_triangle_placement(doc, curve, edge_length=50)
    unit = make.make_bistable_unit(doc, triangles)
    unit.RatioShare = 0.12
    valid(doc)
    assert list(unit.Warnings) == []  # without thickness there is no play
    triangles.Thickness = 1.8
    valid(doc)
    (warning,) = unit.Warnings
    assert "are floppy" in warning
    assert "TargetSnap" in warning
    assert f"{unit.Label}: {warning}" in "".join(capfd.readouterr())  # in the report view
    unit.Deployment = 0.5
    valid(doc)
    assert "floppy" not in "".join(capfd.readouterr())  # said once
    unit.HingePlay = 0  # flexible hinges
    valid(doc)
    assert list(unit.Warnings) == []
    unit.HingePlay, unit.RatioRule = 0.28, "TargetSnap"
    valid(doc)
    assert not any("are floppy:" in warning for warning in unit.Warnings)
