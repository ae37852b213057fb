# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a deployed unit bears in the way of opening further, against searches of other kinds."""

from functools import cache

import numpy as np
import pytest

from BistableWB.origami import rigid
from BistableWB.origami.design import Single, Thickness, TubeDesign
from BistableWB.origami.snap.beyond import bears_beyond
from BistableWB.origami.snap.contact import contacts
from BistableWB.origami.snap.elastic import elastic_unit
from BistableWB.origami.snap.forces import follow, unit_forces
from BistableWB.origami.snap.materials import material
from BistableWB.origami.snap.minimum import Pull, State, least
from BistableWB.origami.snap.study import layouts_of
from BistableWB.origami.snap.table import USUAL
from BistableWB.origami.snap.targets import TargetMargin
from BistableWB.origami.thick.closure import RIGHT
from BistableWB.origami.units.ratios import RatioRule

PANELS = Thickness(USUAL.face_thickness, USUAL.gap_between_planes, True, None, USUAL)
PLA = material("PLA")


def tube(theta=70.0, margin=2.5):
    """One unit as the first of the arch of the examples."""
    rule = RatioRule("TargetSnap", target=TargetMargin(80.0, USUAL.pitch, margin, USUAL.play))
    return TubeDesign(Single(np.radians(theta), 80.0, pitch=1.8), rule, 2.5, PANELS).thick()


def beyond(**given):
    made = tube(**given)
    return unit_forces(made.thick, layouts_of(made, USUAL)[0], USUAL, PLA, openings=np.array([1.0]))


@cache
def deployed():
    """The elastic unit, and its rest at the deployed state."""
    made = tube()
    (layout,) = layouts_of(made, USUAL)
    unit = elastic_unit(made.thick, layout, contacts([layout], USUAL), USUAL, PLA)
    poses = made.thick.states([[1.0]])[0]
    poses[..., :3, 3] *= made.thick.scale
    return made.thick, unit, follow(unit, np.array([1.0]), poses)[0]


def unbroken(_rest, _opening):
    """Knuckles that bear everything: then panels buckle."""
    return 0.0


@cache
def limit():
    """What it bears before its panels buckle."""
    thick, unit, rest = deployed()
    return bears_beyond(unit, thick, rest, unbroken)


@pytest.mark.slow
def test_units_nearly_the_same_bear_nearly_the_same():
    first = beyond().beyond
    assert first > 300
    assert beyond(theta=69.98, margin=2.499).beyond == pytest.approx(first, rel=0.03)


@pytest.mark.slow
def test_from_wherever_it_starts_it_bears_as_much():
    """From states thrown off by tenths of a millimetre, with bent panels."""
    thick, unit, rest = deployed()
    random = np.random.default_rng(3)
    for size in (0.003, 0.01):
        turn = size * random.normal(size=(15, 3))
        poses = rigid.pose(
            rigid.rotation(turn) @ rest.state.poses[:, :3, :3],
            rest.state.poses[:, :3, 3] + 20 * size * random.normal(size=(15, 3)),
        )
        modes = rest.state.modes + 0.1 * random.normal(size=rest.state.modes.shape)
        thrown = least(unit, 1.0, State(poses, modes), rounds=150)
        assert thrown.energy > 0.97 * rest.energy
        assert bears_beyond(unit, thick, thrown, unbroken) == pytest.approx(limit(), rel=0.05)


@pytest.mark.slow
@pytest.mark.parametrize(("share", "holds"), [(0.85, True), (1.15, False)])
def test_a_dead_couple_opens_it_for_good_above_that_only(share, holds):
    """Nothing prescribes the opening: the couple is there and the unit goes where it goes."""
    _, unit, rest = deployed()
    lever, state, turned = 20.0, rest.state, 1.0
    arm = lever * np.array([1.0, 0, 0])
    points = rigid.apply(rigid.inverse(state.poses[RIGHT]), np.stack([arm, -arm]))
    full = np.sign(unit.turn) * share * limit() / (2 * lever**2) * np.cross(unit.leg, arm)
    for part in np.linspace(0.2, 1, 9):
        pull = Pull(points, part * np.stack([full, -full]))
        state = least(unit, 1.0, state, pull=pull, rounds=150).state
        turned = rigid.twist_angle(state.poses[RIGHT, :3, :3], unit.leg) / unit.turn
        if not 0.9 < turned < 1.09:
            break
    assert (0.9 < turned < 1.09) == holds
