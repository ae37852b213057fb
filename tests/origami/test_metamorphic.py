# SPDX-License-Identifier: LGPL-2.1-or-later
"""One tube however its curve is given: moved, turned, scaled, mirrored, split, from either end."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapes import OnSphere

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.rules import PlacementRule
from BistableWB.origami.design import CurveGeometry, Placing, TubeDesign
from BistableWB.origami.errors import Refusal
from BistableWB.origami.units.ratios import RatioRule

EDGE, GAMMA = 30.0, np.radians(25)
pytestmark = pytest.mark.slow
SOME = settings(max_examples=8, deadline=None)
SEEDS = st.integers(0, 10_000)


class Seen:
    """A curve carried by ``matrix`` (4, 4), its parameter changed by ``warp``."""

    def __init__(self, curve, matrix=None, warp=None, breaks=()):
        self.curve, self.warp = curve, warp or (lambda s: s)
        self.matrix = np.eye(4) if matrix is None else matrix
        if len(breaks):
            self.breaks = (0.0, *breaks, 1.0)

    def point(self, s):
        there = self.curve.point(self.warp(np.asarray(s, float)))
        return there @ self.matrix[:3, :3].T + self.matrix[:3, 3]


def drawn(seed, family):
    """(curve, legs, radius of the sphere) of a family that a tube of ‖AB‖ 30 can follow."""
    rng = np.random.default_rng(seed)
    if family == "Sphere":
        return OnSphere(150.0, rng.uniform(0, 0.15)), ("point", (0.0, 0.0, 0.0)), 150.0
    away = rng.uniform(-60, 60, 5)
    height = rng.uniform(-20, 20, 5) if family == "General" else np.zeros(5)
    points = np.column_stack([np.linspace(0, 300, 5), away, height])
    return Bezier(points), ("parallel", (0.0, 0.0, 1.0)), None


def tube_along(curve, family, legs, radius, size=1.0, rule="EndFit", flip=False):
    geometry = CurveGeometry(curve, family, legs, radius)
    where = Placing(
        geometry, size * EDGE, GAMMA, pitch=1.8 * size, flip=flip, rule=PlacementRule(rule)
    )
    return TubeDesign(where, RatioRule()).tube()


def carried(matrix, legs):
    """Legs of a strip that is moved."""
    kind, vector = legs
    weight = 1.0 if kind == "point" else 0.0
    return kind, tuple(matrix[:3, :3] @ vector + weight * matrix[:3, 3])


def either(seed, family):
    """A curve and its tube, or None where it is refused."""
    given_curve = drawn(seed, family)
    try:
        return *given_curve, tube_along(given_curve[0], family, *given_curve[1:])
    except Refusal:
        return None


def turned(rng):
    """A random rotation (3, 3)."""
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    q[:, 0] *= np.linalg.det(q)
    return q


@pytest.mark.parametrize("family", ["Plane", "General", "Sphere"])
@SOME
@given(SEEDS)
def test_moved_by_a_kilometre_and_turned(family, seed):
    case = either(seed, family)
    if case is None:
        return
    curve, legs, radius, tube = case
    rng = np.random.default_rng(seed + 1)
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turned(rng), rng.uniform(-1e6, 1e6, 3)
    away = tube_along(Seen(curve, matrix), family, carried(matrix, legs), radius)
    expected = tube.deployed() @ matrix[:3, :3].T + matrix[:3, 3]
    assert away.deployed() == pytest.approx(expected, abs=1e-5)


@pytest.mark.parametrize("family", ["Plane", "General", "Sphere"])
@SOME
@given(SEEDS, st.floats(0.05, 60))
def test_scaled_with_all_its_lengths(family, seed, size):
    case = either(seed, family)
    if case is None:
        return
    curve, legs, radius, tube = case
    matrix = np.diag([size, size, size, 1.0])
    scaled = tube_along(
        Seen(curve, matrix), family, carried(matrix, legs), radius and size * radius, size
    )
    assert scaled.deployed() / size == pytest.approx(tube.deployed(), abs=1e-6)


@pytest.mark.parametrize("family", ["Plane", "General", "Sphere"])
@SOME
@given(SEEDS)
def test_mirrored(family, seed):
    case = either(seed, family)
    if case is None:
        return
    curve, legs, radius, tube = case
    matrix = np.diag([1.0, -1.0, 1.0, 1.0])
    other = tube_along(Seen(curve, matrix), family, carried(matrix, legs), radius)
    if family != "Plane" or len(other) != len(tube):  # which side it starts on may be the left one
        flipped = tube_along(Seen(curve, matrix), family, carried(matrix, legs), radius, flip=True)
        apart = [
            len(t) != len(tube) or np.ptp(t.unit.theta - tube.unit.theta) for t in (other, flipped)
        ]
        other = (other, flipped)[int(np.argmin(apart))]
    assert other.unit.theta == pytest.approx(tube.unit.theta, abs=1e-7)
    assert other.unit.ratio == pytest.approx(tube.unit.ratio, abs=1e-7)


@pytest.mark.parametrize("family", ["Plane", "General", "Sphere"])
@SOME
@given(SEEDS, st.floats(0.2, 0.8), st.floats(0.2, 0.8))
def test_split_at_a_point_and_with_knots_that_change_nothing(family, seed, at, there):
    case = either(seed, family)
    if case is None:
        return
    curve, legs, radius, tube = case

    def warp(s):
        return np.interp(s, [0, at, 1], [0, there, 1])

    split = tube_along(Seen(curve, None, warp, (at,)), family, legs, radius)
    assert split.deployed() == pytest.approx(tube.deployed(), abs=1e-6)
    knots = tuple(np.sort(np.random.default_rng(seed).uniform(0, 1, 5)))
    knotted = tube_along(Seen(curve, breaks=knots), family, legs, radius)
    assert knotted.deployed() == pytest.approx(tube.deployed(), abs=1e-6)


@SOME
@given(SEEDS)
def test_from_the_other_end(seed):
    """Between fixed ends a strip without thickness is the same zigzag, seen from either of them."""
    case = either(seed, "Plane")
    if case is None:
        return
    curve, legs = case[:2]
    back = Seen(curve, warp=lambda s: 1 - s)
    found = []
    for one in (curve, back):
        for flip in (False, True):
            geometry = CurveGeometry(one, "Plane", legs)
            where = Placing(geometry, EDGE, GAMMA, flip=flip, rule=PlacementRule("EndFit"))
            found.append(np.array(where.placement().thetas))
    forth, backwards = found[:2], [thetas[::-1] for thetas in found[2:]]
    apart = min(np.abs(a - b).max() for a in forth for b in backwards if len(a) == len(b))
    assert apart < 1e-6


def test_a_long_zigzag_that_hangs_on_every_hundredth_of_a_degree_is_found_wherever_it_lies():
    """97 units at 4.9°: the end moves by much more than gamma says, and steps from afar crawl."""
    heights = [3.8, 19.3, 26.7, 22.9, 4.8, 43.6, 11.8, 49.9]
    across = [32.8, 8.5, -92.2, -96.5, -89.7, -14.9, -78.3, 27.9]
    points = np.column_stack([150.567 * np.arange(8), across, heights])
    legs = ("parallel", (-0.064, -0.152, 0.986))
    found = []
    for far in (0.0, 1e-9, 5e5):
        where = Placing(
            CurveGeometry(Bezier(points + np.array([far, -far, 0])), "General", legs), 46.605,
            np.radians(4.876), pitch=1.8, rule=PlacementRule("EndFit"),
        )  # fmt: skip
        found.append(where.placement())
    for other in found[1:]:
        assert len(other.thetas) == len(found[0].thetas)
        assert np.degrees(other.thetas) == pytest.approx(np.degrees(found[0].thetas), abs=1e-4)


def test_a_straight_curve_of_uneven_speed_starts_on_one_side_wherever_it_lies():
    line = Bezier([(0, 0, 0), (234.5, 0, 0), (78.2, 0, 0), (469.0, 0, 0)])
    rng = np.random.default_rng(5)
    sides = set()
    for _ in range(12):
        matrix = np.eye(4)
        matrix[:3, :3], matrix[:3, 3] = turned(rng), rng.uniform(-1e6, 1e6, 3)
        legs = carried(matrix, ("parallel", (0.0, 0.0, 1.0)))
        tube = tube_along(Seen(line, matrix), "Plane", legs, None)
        sides.add(tuple(tube.incoming_left))
    assert len(sides) == 1
