# SPDX-License-Identifier: LGPL-2.1-or-later
"""The ruling proposed for space curves, and rulings that are refused with the place named."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from BistableWB.origami.curves import ruling
from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place

few = settings(max_examples=12, deadline=None, derandomize=True)
RISING = Bezier([[0, 0, 0], [60, 120, 20], [180, 120, 60], [240, 0, 70]])
LOOP = Bezier([[0, 0, 0], [300, 200, 0], [-100, 200, 10], [200, 0, 10]])


class Made:
    def __init__(self, function):
        self.function = function

    def point(self, s):
        return np.stack(self.function(np.asarray(s, float)), -1)


def helix(pitch, turns):
    def function(s):
        a = 2 * np.pi * turns * s
        return 100 * np.cos(a), 100 * np.sin(a), pitch * turns * s

    return Made(function)


def on_sphere(centre, radius):
    def function(s):
        longitude, latitude = 2 * s, 0.6 * np.sin(4 * s)
        level = np.cos(latitude)
        unit = level * np.cos(longitude), level * np.sin(longitude), np.sin(latitude)
        return [c + radius * x for c, x in zip(centre, unit, strict=True)]

    return Made(function)


def test_closed_curves_in_space_get_a_direction_and_no_overlap_at_their_seam():
    def wavy(s):
        a = 2 * np.pi * s
        return 120 * np.cos(a), 120 * np.sin(a), 20 * np.sin(2 * a)

    def trefoil(s):
        a = 2 * np.pi * s
        x, y = np.sin(a) + 2 * np.sin(2 * a), np.cos(a) - 2 * np.cos(2 * a)
        return 100 * x, 100 * y, -100 * np.sin(3 * a)

    for function in (wavy, trefoil):
        kind, direction = ruling.default_ruling(Made(function))
        assert kind == "parallel"
        assert direction == pytest.approx((0, 0, 1), abs=1e-6)
    flat = Made(lambda s: [*trefoil(s)[:2], 0 * s])  # this one does meet itself
    with pytest.raises(ValueError, match="overlaps itself"):
        ruling.check_ruling(flat, ("parallel", (0, 0, 1)))


@few
@given(st.floats(-1, 1), st.floats(-1, 1), st.floats(10, 90))
def test_a_plane_curve_gets_the_normal_of_its_plane(a, b, rise):
    u, v = np.array([1, 0, a]), np.array([0, 1, b])
    curve = Bezier([x * u + y * v for x, y in ((0, 0), (60, rise), (180, 120), (240, 0))])
    kind, direction = ruling.default_ruling(curve)
    assert kind == "parallel"
    normal = np.cross(u, v) / np.linalg.norm(np.cross(u, v))
    np.testing.assert_allclose(direction, normal, atol=1e-6)
    assert ruling.openness(curve, (kind, direction)) == pytest.approx(np.pi / 2, abs=1e-5)


def test_a_straight_line_gets_an_axis_across_it():
    assert ruling.default_ruling(Bezier([[0, 0, 0], [100, 0, 0]])) == ("parallel", (0, 0, 1))
    assert ruling.default_ruling(Bezier([[0, 0, 0], [0, 0, 100]])) == ("parallel", (0, 1, 0))


def test_a_curve_on_a_sphere_gets_its_centre():
    kind, centre = ruling.default_ruling(on_sphere((5, 6, 7), 100), 20.0)
    assert kind == "point"
    np.testing.assert_allclose(centre, (5, 6, 7), atol=1e-6)


@pytest.mark.parametrize("pitch", [5, 15, 30, 50])
def test_a_helix_gets_its_axis(pitch):
    kind, direction = ruling.default_ruling(helix(pitch, 4), 20.0 if pitch == 50 else None)
    assert kind == "parallel"
    np.testing.assert_allclose(direction, (0, 0, 1), atol=1e-9)
    slope = np.arctan(pitch / (200 * np.pi))
    assert ruling.openness(helix(pitch, 4), None) == pytest.approx(np.pi / 2 - slope, abs=1e-4)


def test_the_proposal_is_more_open_than_any_axis_and_can_be_placed():
    legs = ruling.default_ruling(RISING, 40.0)
    proposed = ruling.openness(RISING, legs)
    assert proposed > np.radians(89)
    for axis in np.eye(3):
        assert ruling.openness(RISING, ("parallel", axis)) < proposed
    assert len(place(RISING, 40.0, np.radians(20), legs=legs)) > 15


def assert_names_ruling(message):
    assert message.startswith("Ruling: ")


@few
@given(
    st.lists(
        st.tuples(*[st.integers(-100, 100)] * 3), min_size=3, max_size=5, unique=True
    )
)  # fmt: skip
def test_a_proposal_passes_its_own_check(points):
    curve = Bezier(points)
    try:
        legs = ruling.default_ruling(curve, 20.0)
    except ValueError as error:
        assert_names_ruling(str(error))
        return
    ruling.check_ruling(curve, legs, 20.0)
    assert ruling.openness(curve, legs) >= ruling.LEAST_OPENNESS


def test_legs_along_the_curve_are_refused_with_the_place():
    vertical = Bezier([[0, 0, 0], [0, 0, 50], [50, 0, 100]])
    with pytest.raises(ValueError, match=r"run along the curve near \(.*choose another direction"):
        ruling.check_ruling(vertical, None)
    with pytest.raises(ValueError, match="run along the curve"):
        ruling.check_ruling(Bezier([[10, 0, 0], [100, 0, 0]]), ("point", (0, 0, 0)))


def test_an_overlapping_view_is_refused_with_the_place():
    with pytest.raises(ValueError, match=r"overlaps itself: \(.*lies in front of \(") as error:
        ruling.check_ruling(LOOP, None, 20.0)
    assert "(98" in str(error.value)
    ruling.check_ruling(LOOP, None, 2.0)  # 8 mm apart along the legs: thin tubes pass
    with pytest.raises(ValueError, match="overlaps itself"):
        ruling.default_ruling(LOOP, 20.0)
    with pytest.raises(ValueError, match="overlaps itself"):
        ruling.check_ruling(helix(20, 3), None, 20.0)


def test_a_view_from_a_point_overlaps_likewise():
    ruling.check_ruling(helix(50, 0.9), ("point", (0, 0, -100)), 20.0)
    with pytest.raises(ValueError, match="overlaps itself"):
        ruling.check_ruling(LOOP, ("point", (100, 100, 500)), 20.0)


@few
@given(st.floats(0, 1))
def test_a_viewpoint_on_the_curve_is_refused(s):
    with pytest.raises(ValueError, match=r"viewpoint \(.*lies on the curve.*move it away"):
        ruling.check_ruling(RISING, ("point", RISING.point(s) + np.array([0, 0, 1])), 40.0)


def test_a_curve_without_length_is_refused():
    with pytest.raises(ValueError, match="no length"):
        ruling.default_ruling(Made(lambda s: (0 * s, 0 * s, 0 * s)))
