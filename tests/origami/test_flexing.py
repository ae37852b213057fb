# SPDX-License-Identifier: LGPL-2.1-or-later
"""Units with strips of soft material: what they take to open."""

from dataclasses import replace

import numpy as np
import pytest

from BistableWB.origami.hinges.layout import unit_layout
from BistableWB.origami.hinges.parameters import FLEXIBLE
from BistableWB.origami.snap.flexing import flexible_forces, flexing
from BistableWB.origami.snap.materials import TPU, material
from tests.origami.test_elastic import HINGES, unit

STRIPS = replace(HINGES, hinge_type=FLEXIBLE)
OPENINGS = np.array([0.0, 0.3, 0.6, 0.8, 0.9, 1.0])


@pytest.fixture(scope="module")
def firm():
    thick, _ = unit(0.4865)
    return thick, unit_layout(thick.axes, STRIPS, 80)


def forces(firm, young):
    soft = material(TPU).edited(young=young)
    return flexible_forces(*firm, STRIPS, soft, openings=OPENINGS)


def test_energy_is_in_proportion_to_stiffness(firm):
    soft, stiff = (forces(firm, young) for young in (60.0, 120.0))
    assert soft.found
    assert stiff.closing == pytest.approx(2 * soft.closing, rel=0.02, abs=0.2)
    assert np.isfinite(stiff.closing_torques).all()
    assert stiff.weakest.share > 0


def test_strips_bend_by_the_angles_of_the_creases(firm):
    """Flat nothing is bent; deployed the legs at B turn by all of theta together."""
    thick, layout = firm
    made = flexing(thick, layout, STRIPS, material(TPU))
    flat, deployed = (thick.poses(opening) for opening in (0.0, 1.0))
    assert made.turned(flat) == pytest.approx(np.zeros(23), abs=1e-6)
    turned = made.turned(deployed)
    assert turned[-4:].max() < np.pi
    assert turned[[-1, -4]].sum() > np.radians(50)
    assert made.bent(deployed) > 100


def test_without_bending_a_unit_with_strips_snaps(firm):
    """Strips have no play: stretched alone, they are passed over a barrier."""
    thick, layout = firm
    soft = material(TPU)
    found = flexible_forces(thick, layout, STRIPS, soft, openings=OPENINGS)
    made = flexing(thick, layout, STRIPS, soft)
    bent = np.array([made.bent(thick.poses(x)) for x in OPENINGS])
    stretched = found.closing - bent
    assert stretched[2:5].max() > 5 * abs(stretched[[0, -1]]).max()
