# SPDX-License-Identifier: LGPL-2.1-or-later
"""Margins for a force or a load: what comes out is studied again; what cannot be is refused."""

import numpy as np
import pytest

from BistableWB.origami.design import Single, Thickness, TubeDesign
from BistableWB.origami.errors import Refusal
from BistableWB.origami.fit.aiming import LEAST, Aim, aimed
from BistableWB.origami.snap.forces import snap_forces
from BistableWB.origami.snap.materials import material
from BistableWB.origami.snap.study import Conditions, layouts_of
from BistableWB.origami.snap.table import USUAL
from BistableWB.origami.snap.targets import TargetMargin
from BistableWB.origami.units.ratios import RatioRule

EDGE, PITCH = 80.0, 1.8
PLA = Conditions(material("PLA"))
THETAS = np.radians([40.0, 60.0])


def design(margin=1.8):
    target = TargetMargin(EDGE, PITCH, margin, USUAL.play)
    panels = Thickness(USUAL.face_thickness, USUAL.gap_between_planes, True, None, USUAL)
    where = Single(np.radians(55), EDGE, pitch=PITCH)
    return TubeDesign(where, RatioRule("TargetSnap", target=target), 2.5, panels)


@pytest.mark.slow
@pytest.mark.parametrize("wanted", [0.8, 2.0])
def test_a_hand_feels_what_was_wanted(wanted):
    found = aimed(design(), USUAL, PLA, Aim(force=wanted))
    tube = design(found.margins).thick()
    (unit,) = snap_forces(tube.thick, layouts_of(tube, USUAL), USUAL, PLA.material)
    assert found.margins[0] == LEAST or unit.hand <= 1.3 * wanted
    assert unit.hand >= 0.95 * wanted


@pytest.mark.slow
def test_more_than_can_be_is_refused_with_the_cure():
    with pytest.raises(Refusal, match="EdgeLength") as refused:
        aimed(design(), USUAL, PLA, Aim(force=500.0))
    assert refused.value.parameter == "EdgeLength"


@pytest.mark.parametrize("aim", [Aim(), Aim(carry=-1), Aim(carry=1.5, force=2), Aim(force=np.nan)])
def test_nothing_to_aim_at_is_refused(aim):
    with pytest.raises(Refusal, match="for example"):
        aimed(design(), USUAL, PLA, aim)


def test_every_unit_may_have_its_own_margin():
    both = TargetMargin(EDGE, PITCH, (1.4, 2.2), USUAL.play).choose(THETAS)
    for k, margin in enumerate((1.4, 2.2)):
        one = TargetMargin(EDGE, PITCH, margin, USUAL.play).choose(THETAS)
        assert both.ratio[k] == pytest.approx(one.ratio[k])


def test_another_number_of_units_is_refused():
    with pytest.raises(Refusal, match="UnitMargins has 3 numbers and there are 2 units"):
        TargetMargin(EDGE, PITCH, (1.4, 2.2, 1.8), USUAL.play).choose(THETAS)
