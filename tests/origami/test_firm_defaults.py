# SPDX-License-Identifier: LGPL-2.1-or-later
"""What New tube makes, and the arch of the examples: firm deployed, standing in every direction."""

from dataclasses import replace

import numpy as np
import pytest

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.rules import PlacementRule
from BistableWB.origami.design import CurveGeometry, Placing, Single, Thickness, TubeDesign
from BistableWB.origami.hinges.standoff_inputs import StandOffs
from BistableWB.origami.snap.bearing import PRESS, Preloader
from BistableWB.origami.snap.contact import holding
from BistableWB.origami.snap.materials import material
from BistableWB.origami.snap.study import Conditions, study
from BistableWB.origami.snap.table import USUAL
from BistableWB.origami.snap.targets import FIRM, TargetMargin
from BistableWB.origami.thick.preload import PATTERN, without
from BistableWB.origami.units.ratios import RatioRule

NEW = Bezier([(0, 0), (60, 120), (180, 120), (240, 0)])
ARCH = Bezier([(0, 0), (90, 180), (270, 180), (360, 0)])
PANELS = Thickness(USUAL.face_thickness, USUAL.gap_between_planes, True, None, USUAL)


def firm(edge, margin=FIRM):
    return RatioRule("TargetSnap", target=TargetMargin(edge, USUAL.pitch, margin, USUAL.play))


@pytest.fixture(scope="module")
def unit():
    """A preloaded unit, theta 55°, ‖AB‖ 80."""
    return TubeDesign(Single(np.radians(55), 80.0, pitch=1.8), firm(80.0), 2.5, PANELS).thick()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("curve", "edge", "gamma", "margin"), [(NEW, 70.0, 30, FIRM), (ARCH, 80.0, 29, 2.5)]
)
def test_it_hardly_wobbles_stands_and_does_not_break(curve, edge, gamma, margin):
    along = PlacementRule("EndFit")
    where = Placing(CurveGeometry(curve), edge, np.radians(gamma), 1.8, rule=along)
    tube, pla = TubeDesign(where, firm(edge, margin), 2.5, PANELS).thick(), material("PLA")
    # with the stand-offs that new hinge sets have: they weigh
    printed = replace(USUAL, process="FDM, stand-offs", standoffs=StandOffs())
    found = study(tube, printed, Conditions(pla))
    assert found.slop_share < 0.02
    assert max(each.weakest.share for each in found.units) < 1
    assert found.load.turned.min() >= 1.2, found.load.turned


def test_at_rest_cones_press_as_much_as_they_should_and_flat_not_at_all(unit):
    """By the law of contacts, which says nothing of how the poses were found."""
    held = holding(unit.thick, USUAL)
    flat, deployed = (unit.thick.poses(x)[None] if unit.thick.poses(x).ndim == 3
                      else unit.thick.poses(x) for x in (0.0, 1.0))  # fmt: skip
    assert held.needed(flat).max() <= 0
    assert held.needed(deployed).max() == pytest.approx(PRESS, rel=0.02)


def test_what_is_preloaded_closes_without_it(unit):
    assert unit.thick.misfit(1.0).max() > 0.1
    assert without(unit.thick).misfit(1.0).max() < 1e-6


def test_poses_on_the_way_join_those_of_both_ends(unit):
    steps = unit.thick.poses(np.array([0.97, 0.985, 1.0])).reshape(3, 15, 4, 4)
    assert np.abs(steps[2] - steps[1])[..., :3, 3].max() < 2.5
    tiny = unit.thick.poses(np.array([1 - 1e-6, 1.0])).reshape(2, 15, 4, 4)
    assert np.abs(tiny[1] - tiny[0]).max() < 1e-3


def test_a_given_amount_is_that_for_every_unit(unit):
    thick = without(unit.thick)
    made = Preloader(0.2, USUAL)(thick)
    assert made.rest.amounts == pytest.approx(0.2)
    moved = np.reshape(made.shifts - thick.shifts, PATTERN.shape)
    assert moved == pytest.approx(0.2 * PATTERN, abs=1e-9)
    assert Preloader(0.0, USUAL)(thick) is thick


def test_five_knuckles_and_more_are_held_by_what_they_need_and_three_by_nothing(unit):
    thick = without(unit.thick)
    seven, three = (replace(USUAL, segment_width=0.0, segmentations=n) for n in (7, 3))
    made = Preloader(None, seven)(thick)
    needed = holding(made, seven).needed(np.reshape(made.poses(1.0), (1, 15, 4, 4)))
    assert needed.max() == pytest.approx(PRESS, rel=0.02)
    assert Preloader(None, three)(thick) is thick
