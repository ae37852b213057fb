"""Bézier curves of any degree."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from BistableWB.origami.curves.bezier import Bezier


def casteljau(points, s):
    points = np.array(points, float)
    while len(points) > 1:
        points = (1 - s) * points[:-1] + s * points[1:]
    return points[0]


@given(st.integers(2, 30), st.integers(0, 1000))
def test_agrees_with_de_casteljau(n, seed):
    points = np.random.default_rng(seed).uniform(-100, 100, (n, 3))
    curve = Bezier(points)
    s = np.linspace(0, 1, 11)
    expected = [casteljau(points, t) for t in s]
    assert curve.point(s) == pytest.approx(np.array(expected), abs=1e-11)
    assert curve.point(0.3) == pytest.approx(casteljau(points, 0.3), abs=1e-11)


def test_tangent_and_curvature_of_a_parabola():
    curve = Bezier([(-1, 1), (0, -1), (1, 1)])  # y = x² for x = 2 s − 1
    s = np.array([0.0, 0.25, 0.5, 1.0])
    x = 2 * s - 1
    slope = np.stack([np.ones(4), 2 * x, np.zeros(4)], 1)
    assert curve.tangent(s) == pytest.approx(slope / np.linalg.norm(slope, axis=1)[:, None])
    assert curve.curvature(s) == pytest.approx(2 / (1 + 4 * x**2) ** 1.5)


def test_shapes_follow_the_parameter():
    curve = Bezier([(0, 0), (1, 2), (3, 1)])
    assert curve.point(0.5).shape == (3,)
    assert curve.point(np.zeros((2, 5))).shape == (2, 5, 3)
    assert np.ndim(curve.curvature(0.5)) == 0
    assert Bezier([(0, 0), (3, 4)]).curvature(0.5) == 0


@pytest.mark.parametrize(
    ("points", "words"),
    [
        ([(0, 0)], "at least two control points"),
        ([], "at least two control points"),
        ([(0, 0, 0, 0), (1, 1, 1, 1)], "2 or 3 coordinates"),
        ([(0, 0), (0, 0)], "points 1 and 2 coincide"),
        ([(0, 0), (5, 0), (5, 0), (9, 0)], "points 2 and 3 coincide"),
        ([(0, 0), (np.nan, 1)], "control point 2 .*not a finite"),
        ([(np.inf, 0), (1, 1)], "control point 1 .*not a finite"),
    ],
)
def test_refusals(points, words):
    with pytest.raises(ValueError, match=words):
        Bezier(points)
