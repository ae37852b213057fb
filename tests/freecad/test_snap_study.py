# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a HingeSet's tube snaps, wobbles and stands, as its properties say it."""

import FreeCAD as App
import numpy as np
import pytest

from BistableWB import make, pictures
from BistableWB.solids.tessellation import placed_meshes


@pytest.fixture(scope="module")
def hinges():
    """One unit, theta 55°, ‖AB‖ 80, at a firm ratio."""
    doc = App.newDocument()
    unit = make.make_bistable_unit(doc, theta=55, ratio=0.49, edge_length=80)
    made = make.make_hinge_set(doc, unit)
    doc.recompute()
    assert made.isValid()
    yield made
    App.closeDocument(doc.Name)


def test_results_are_there_when_asked_for_and_go_when_they_no_longer_hold(hinges):
    assert hinges.Barriers == []
    found = make.measure_snap(hinges)
    assert hinges.Barriers == pytest.approx([unit.barrier for unit in found.units])
    assert hinges.Barriers[0] > 2
    assert hinges.HandForces[0] > 0.2
    volume = sum(solid.Volume for solid in hinges.Shape.Solids)
    assert hinges.Weight == pytest.approx(1.24e-3 * volume, rel=1e-3)
    assert 0 < hinges.Stresses[0] < 1
    assert hinges.LeastSafety == pytest.approx(found.load.turned.min())
    assert 0 < hinges.LeastSafety <= hinges.SafetyFactors[0]
    hinges.Document.recompute()
    assert len(hinges.Barriers) == 1
    hinges.Density = 2.5
    hinges.Document.recompute()
    assert hinges.SafetyFactors == []
    make.measure_snap(hinges)
    assert hinges.Weight == pytest.approx(found.load.weight * 2.5 / 1.24)
    hinges.Density = 0


def test_preload_takes_up_the_play(hinges):
    hinges.Preload = 0
    hinges.Document.recompute()
    make.measure_snap(hinges)
    assert hinges.PreloadRule == "Given"  # whoever says how much means it
    loose = hinges.FreeBends[0], hinges.FreeTwists[0], hinges.EndSlop.Value
    hinges.PreloadRule = "Automatic"
    hinges.Document.recompute()
    assert 0.7 < hinges.Preloads[0] < 1.5
    make.measure_snap(hinges)
    assert hinges.FreeBends[0] < 0.1 * loose[0]
    assert hinges.FreeTwists[0] < 0.1 * loose[1]
    assert hinges.EndSlop.Value < 0.3 * loose[2]
    assert hinges.DeployedMisfit.Value < 1e-6  # apart from its preload


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("YoungsModulus", -1, "above 0"),
        ("Density", -1, "above 0"),
        ("Strength", -2, "above 0"),
        ("Gravity", App.Vector(0, 0, 0), "no direction"),
    ],
)
def test_what_cannot_be_is_refused_with_the_cure(hinges, name, value, words):
    before = getattr(hinges, name)
    setattr(hinges, name, value)
    with pytest.raises(ValueError, match=words):
        make.measure_snap(hinges)
    setattr(hinges, name, before)


def test_ghosts_begin_at_the_first_block(hinges, tmp_path):
    """And their picture is made."""
    pytest.importorskip("matplotlib")
    found, model = make.measure_snap(hinges), hinges.Proxy.model(hinges)
    ends, deployed = model.extremes(found.slop), model.motions(1)
    (first,) = (k for k, body in enumerate(model.bodies) if (0, "contact_left") in body.members)
    for motions in ends:
        assert motions[first] == pytest.approx(deployed[first], abs=1e-6)
    path = tmp_path / "slop.png"
    meshes = placed_meshes(model.bodies)
    pictures.slop_picture(path, meshes, deployed, ends, found.slop.end)
    assert path.stat().st_size > 5000


def test_strips_of_tpu_have_numbers_too():
    """Finite ones: they have no play, and bend all the way."""
    doc = App.newDocument()
    unit = make.make_bistable_unit(doc, theta=55, ratio=0.49, edge_length=80)
    made = make.make_hinge_set(doc, unit, hinge_type="Flexible")
    doc.recompute()
    found = make.measure_snap(made)
    assert made.Barriers[0] > 0
    assert made.EndSlop.Value == 0
    numbers = [*made.HandForces, *made.Stresses, *made.SafetyFactors, made.Weight, made.FreeLoad]
    assert np.isfinite(numbers).all()
    assert found.units[0].weakest.hinge
    App.closeDocument(doc.Name)
