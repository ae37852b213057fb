# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units between leaning contacts: how near to sin(θ/2) their ratio may come; how they snap."""

import numpy as np
import pytest

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.snap.contact import holding
from BistableWB.origami.snap.margin import assess
from BistableWB.origami.snap.table import USUAL
from BistableWB.origami.snap.targets import TargetMargin
from BistableWB.origami.thick.linkage import ThickUnit
from BistableWB.origami.units import tube as tubes
from BistableWB.origami.units.contacts import contact_pairs
from BistableWB.origami.units.general import general_unit
from BistableWB.origami.units.oblique import leaning
from BistableWB.origami.units.ratios import RatioRule

PITCH, PLAY = 1.8, 0.28
V = ("point", (0.0, 0.0, 0.0))
SEEN = Bezier([(-300, -75, 490), (-112, 225, 600), (150, -225, 580), (340, 112, 470)])


class Helix:
    """Radius 200 mm about z, rising ``pitch`` mm a turn."""

    def __init__(self, pitch, turns=0.5):
        self.pitch, self.turns = pitch, turns

    def point(self, s):
        turn = self.turns * np.asarray(s, float)
        angle = 2 * np.pi * turn
        return np.stack([200 * np.cos(angle), 200 * np.sin(angle), self.pitch * turn], -1)


def contacts(curve, edge=60.0, legs=None):
    placed = place(curve, edge, np.radians(20), PITCH, legs)
    return contact_pairs(placed, edge / 2.5)


def test_upright_contacts_allow_any_ratio_down_to_that_of_the_plane_unit():
    flat = Bezier([(0, 0, 0), (90, 180, 0), (270, 180, 0), (360, 0, 0)])
    theta, leans = leaning(*contacts(flat))
    assert (leans.least == np.sin(theta / 2)[:, None]).all()
    assert leans.size == pytest.approx(1)


@pytest.mark.parametrize("pitch", [50, 100, 200])
def test_the_least_ratio_is_where_units_stop_being_proper(pitch):
    left, right = contacts(Helix(pitch))
    theta, leans = leaning(left, right)
    least = leans.least.max(1)
    assert (least >= np.sin(theta / 2)).all()
    assert general_unit(left, right, least + 0.003 * (1 - least)).isometry_error().max() <= 1e-12
    steep = np.flatnonzero(least > np.sin(theta / 2) + 0.01)
    assert len(steep) or pitch == 50
    for k in steep:
        with pytest.raises(ValueError, match="fold of unit 1 would turn inside out"):
            general_unit(left[k], right[k], least[k] - 0.003)


@pytest.mark.parametrize("pitch", [25, 50, 100, 200])
def test_helices_close_with_the_default_rule(pitch):
    """Four pitches, up to the radius: a proper tube without choosing any ratio."""
    placed = place(Helix(pitch, 0.7), 60.0, np.radians(20), PITCH)
    tube = tubes.along(placed, "General", 2.5, RatioRule())
    assert tube.unit.isometry_error().max() <= 1e-12


@pytest.mark.slow
@pytest.mark.parametrize(
    ("curve", "edge", "legs"), [(Helix(100), 85.0, None), (SEEN, 85.0, V)], ids=["helix", "seen"]
)
def test_a_target_makes_leaning_units_firm(curve, edge, legs):
    """Measured: no unit below 1, and near what was looked up."""
    target = TargetMargin(edge, PITCH, 1.5, PLAY)
    left, right = contacts(curve, edge, legs)
    theta, leans = leaning(left, right)
    found = target.choose(theta, leans)
    some = slice(-3, None)
    unit = general_unit(left[some], right[some], found.ratio[some])
    thick = ThickUnit(unit, 1.2, 0.6).compensated()
    snap = assess(thick, holding(thick, USUAL))
    assert snap.margin.min() > 1.2
    assert snap.strain.max() < 0.02
    expected = target.expected(unit.theta, unit.ratio, leans[some])
    assert expected == pytest.approx(snap.margin, rel=0.2)
    assert target.floppy(unit.theta, unit.ratio, leans[some]) == []


def test_floppy_units_are_named_in_plain_words():
    theta = np.radians([31.0, 52.0, 33.0])
    target = TargetMargin(85.0, PITCH, play=PLAY)
    ratio = RatioRule(share=0.05).ratios(theta)
    (sentence,) = map(str, target.floppy(theta, ratio))
    assert sentence.startswith("Units 1, 3 are floppy")
    assert "TargetSnap" in sentence
    assert "below 1" in sentence
    assert "TargetSnap" not in str(target.floppy(theta, ratio, free=False)[0])
    assert target.floppy(theta, RatioRule(share=0.02).ratios(theta)) == []


def test_ratios_far_from_the_least_are_floppy_however_large():
    """Beyond the table the margin goes on falling."""
    theta = np.radians([45.0])
    target = TargetMargin(400.0, PITCH, play=PLAY)
    margins = [target.expected(theta, c)[0] for c in (0.5, 0.65, 0.8, 0.95)]
    assert (np.diff(margins) < 0).all()
