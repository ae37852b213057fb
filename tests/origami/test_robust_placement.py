# SPDX-License-Identifier: LGPL-2.1-or-later
"""Placement does not fail for what only rounding makes: knots, and where in space a curve lies."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.crossing import CurveTable
from BistableWB.origami.curves.placement import place
from BistableWB.origami.curves.ruling import check_ruling, openness


class Helix:
    """A helix of radius 60 whose knots differ by rounding from the nodes of a table."""

    def __init__(self, turns, count, pitch=40.0):
        self.turns, self.pitch = turns, pitch
        knots = np.linspace(0, 1, count)
        self.breaks = sorted({*knots.tolist(), *np.nextafter(np.arange(513) / 512, 2).tolist()})
        self.breaks = [b for b in self.breaks if b <= 1]

    def point(self, s):
        t = 2 * np.pi * self.turns * np.asarray(s, float)
        rise = self.pitch * t / (2 * np.pi)
        return np.stack([60 * np.cos(t), 60 * np.sin(t), rise], -1)


@pytest.mark.parametrize("turns", [0.5, 1.0, 1.5, 3.0, 4.0])
@pytest.mark.parametrize("count", [20, 98, 201, 300])
def test_helices_never_run_along_their_own_axis(turns, count):
    helix = Helix(turns, count)
    legs = ("parallel", (0, 0, 1))
    climb = np.arctan2(2 * np.pi * 60, helix.pitch)
    assert openness(helix, legs) == pytest.approx(climb, abs=1e-3)
    check_ruling(helix, legs, 30)
    assert (np.diff(CurveTable(helix, 30).lengths) > 0).all()


@pytest.mark.slow
@pytest.mark.parametrize("pitch", [0.0, 1.8])
@given(st.integers(0, 10_000))
def test_a_curve_far_away_gives_the_same_tube(pitch, seed):
    rng = np.random.default_rng(seed)
    points = np.column_stack([np.linspace(0, 300, 6), rng.uniform(-40, 40, 6)])
    points = np.column_stack([points, np.zeros(6)])
    far = rng.uniform(-5e5, 5e5, 3)
    near, away = (place(Bezier(p), 30, 0.35, pitch) for p in (points, points + far))
    assert np.degrees(away.thetas) == pytest.approx(np.degrees(near.thetas), abs=1e-6)
    assert away.points - far == pytest.approx(near.points, abs=1e-6)
