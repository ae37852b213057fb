# SPDX-License-Identifier: LGPL-2.1-or-later
"""Corners are rounded by a radius, kinds are found."""

import numpy as np
import pytest
from shapes import ARCH, Heart, OnSphere, Ring, Rising

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.corners import Rounded
from BistableWB.origami.curves.kinds import found_kind, plane_normal
from BistableWB.origami.curves.placement import place
from BistableWB.origami.curves.rules import END_FIT
from BistableWB.origami.errors import Refusal


class Polyline:
    """Straight pieces through points."""

    def __init__(self, points):
        self.points = np.asarray(points, float)
        steps = np.linalg.norm(np.diff(self.points, axis=0), axis=1)
        self.breaks = np.concatenate([[0], np.cumsum(steps)]) / steps.sum()

    def point(self, s):
        return np.stack([np.interp(s, self.breaks, x) for x in self.points.T], -1)

    @property
    def kinks(self):
        closed = np.allclose(self.points[0], self.points[-1])
        return self.breaks[(0 if closed else 1) : -1]


ELL = Polyline([(0, 0, 0), (200, 0, 0), (200, 150, 0)])


def radii(curve, count=4001):
    """Radii of curvature along a curve, from triples of points."""
    p = curve.point(np.linspace(0, 1, count))
    a, b, c = p[:-2], p[1:-1], p[2:]
    sides = [np.linalg.norm(u - v, axis=1) for u, v in ((a, b), (b, c), (c, a))]
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2
    return np.prod(sides, axis=0) / np.maximum(4 * area, 1e-12)


def test_a_corner_becomes_an_arc_of_the_radius():
    rounded = Rounded(ELL, ELL.kinks, 40)
    assert radii(rounded).min() == pytest.approx(40, rel=0.01)
    assert rounded.total == pytest.approx(350 - 80 + 20 * np.pi, rel=1e-3)
    assert rounded.point(np.array([0.0, 1.0])) == pytest.approx(ELL.points[[0, 2]], abs=1e-9)
    placed = place(rounded, 30, np.radians(20), 1.8, rule=END_FIT)
    assert placed.end_gap < 1e-6


def test_a_radius_that_does_not_fit_is_refused_with_the_largest_that_does():
    with pytest.raises(Refusal, match="147 mm at most") as error:
        Rounded(ELL, ELL.kinks, 160)
    assert error.value.parameter == "CornerRadius"
    assert "(200, 0, 0)" in str(error.value)
    assert Rounded(ELL, ELL.kinks, None, most=500).radii == pytest.approx([147])
    back = Polyline([(0, 0, 0), (200, 0, 0), (0, 1, 0)])
    with pytest.raises(Refusal, match="turns back on itself"):
        Rounded(back, back.kinks, 5)


@pytest.mark.slow
def test_a_square_is_rounded_all_round_and_closes():
    square = Polyline([(0, 0, 0), (200, 0, 0), (200, 200, 0), (0, 200, 0), (0, 0, 0)])
    rounded = Rounded(square, square.kinks, 60)
    assert rounded.closed
    ends = rounded.point(np.array([0.0, 1.0]))
    assert ends[0] == pytest.approx(ends[1], abs=1e-9)
    assert radii(rounded).min() == pytest.approx(60, rel=0.01)
    placed = place(rounded, 30, np.radians(20), 1.8, rule=END_FIT)
    assert placed.midpoints[-1] == pytest.approx(placed.midpoints[0], abs=1e-7)


@pytest.mark.slow
def test_a_heart_closes():
    rounded = Rounded(Heart(), Heart.kinks, 30)
    assert rounded.closed
    placed = place(rounded, 22, np.radians(20), 1.8, rule=END_FIT)
    assert placed.midpoints[-1] == pytest.approx(placed.midpoints[0], abs=1e-7)
    assert len(placed) % 2 == 0


def test_kinds_are_found():
    assert found_kind(ARCH)[0] == "Plane"
    assert found_kind(Bezier([(0, 0, 0), (10, 20, 30)]))[0] == "Plane"
    assert found_kind(Ring(60))[0] == "Plane"
    assert found_kind(Rising())[0] == "General"
    kind, centre, radius = found_kind(OnSphere())
    assert kind == "Sphere"
    assert centre == pytest.approx([0, 0, 0], abs=1e-6)
    assert radius == pytest.approx(300)


def test_a_space_curve_called_plane_is_told_about_general():
    with pytest.raises(Refusal, match="set Kind to General") as error:
        plane_normal(Rising())
    assert error.value.parameter == "Kind"
    assert plane_normal(ARCH) == pytest.approx([0, 0, 1])
