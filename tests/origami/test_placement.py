"""Triangles along a curve: section 3.1 of the paper and docs/theory/hinges.md 5."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place

ARCH = [(0, 0, 0), (60, 120, 0), (180, 120, 0), (240, 0, 0)]


class Arc:
    """Circle of radius ``radius``, turning by ``angle``."""

    def __init__(self, radius, angle):
        self.radius, self.angle = radius, angle

    def point(self, s):
        t = np.asarray(s, float) * self.angle
        return self.radius * np.stack([np.cos(t), np.sin(t), 0 * t], -1)


@pytest.mark.parametrize("family", ["plane", "thick_plane", "general"])
def test_reference_placements(vectors, family):
    for row in vectors[family]:
        placed = place(
            Bezier(row["control_points"]),
            row["edge_length"],
            np.radians(row["gamma"]),
            row.get("pitch", 0.0),
        )
        thetas = row.get("thetas", row.get("angles_at_B_3d"))
        assert len(placed) == row["count"]
        assert np.degrees(placed.thetas) == pytest.approx(thetas, abs=1e-6)
        assert placed.midpoints[-1] == pytest.approx(row["last_midpoint"], abs=1e-6)
        if "first_B" in row:
            assert placed.points[1] == pytest.approx(row["first_B"], abs=1e-6)


@given(st.integers(2, 30), st.integers(0, 10_000), st.floats(15, 30))
def test_invariants_on_random_curves(n, seed, gamma):
    rng = np.random.default_rng(seed)
    points = np.column_stack([np.linspace(0, 300, n), rng.uniform(-80, 80, n)])
    placed, refusal = placed_or_refused(Bezier(points), 25, np.radians(gamma))
    if placed is None:
        assert "too small near" in refusal or "meets itself" in refusal
        return
    check_invariants(placed, Bezier(points), 25)


def placed_or_refused(curve, edge, gamma):
    try:
        return place(curve, edge, gamma), ""
    except ValueError as error:
        return None, str(error)


def check_invariants(placed, curve, edge):
    """Midpoints on the curve, equal segments, first crossing outward, alternate sides."""
    mids = (placed.points[:-1] + placed.points[1:]) / 2
    assert np.abs(curve.point(placed.parameters) - mids).max() <= 1e-9 * edge
    lengths = np.linalg.norm(np.diff(placed.points, axis=0), axis=1)
    assert lengths == pytest.approx(np.full(len(lengths), edge), rel=1e-12)
    sides = placed.sides
    assert (sides[1:] == -sides[:-1]).all()
    for k in range(len(placed)):  # brute force: nothing outside the circle before the crossing
        s = np.linspace(placed.parameters[k], placed.parameters[k + 1], 301)[1:-1]
        reach = np.linalg.norm(curve.point(s) - placed.points[k + 1], axis=1)
        assert reach.max() <= edge / 2 * (1 + 1e-9)
    rest = curve.point(np.linspace(placed.parameters[-1], 1, 301))
    assert np.linalg.norm(rest - placed.points[-1], axis=1).max() <= edge / 2 * (1 + 1e-9)


def test_first_crossing_is_found_on_a_narrow_excursion():
    """A spike of a thousandth of the curve is not stepped over where the curve gives its pieces."""

    class Spike:
        breaks = (0, 0.073, 0.074, 1)

        def point(self, s):
            s = np.asarray(s, float)
            bump = -16.0 * np.exp(-(((s - 0.0735) / 2e-4) ** 2))
            return np.stack([100 * s, bump, 0 * s], -1)

    placed = place(Spike(), 30, np.radians(20))
    assert 0.0728 < placed.parameters[1] < 0.0735  # on the spike's flank, not beyond it


def test_arc_gives_two_alternating_angles():
    placed = place(Arc(200, 3), 40, np.radians(17))
    thetas = np.degrees(placed.thetas)
    assert np.ptp(thetas[::2]) < 1e-9
    assert np.ptp(thetas[1::2]) < 1e-9
    assert abs(thetas[0] - thetas[1]) > 1


@given(st.floats(8, 60))
def test_straight_line_gives_twice_gamma(gamma):
    placed = place(Bezier([(0, 0), (400, 100)]), 25, np.radians(gamma))
    assert np.degrees(placed.thetas) == pytest.approx(np.full(len(placed), 2 * gamma), abs=1e-7)


@given(st.floats(0, 2 * np.pi), st.floats(-1, 1), st.integers(0, 99))
def test_any_plane_in_space_gives_the_same_tube(turn, tilt, seed):
    axis = np.array(
        [np.sqrt(1 - tilt**2) * np.cos(turn), np.sqrt(1 - tilt**2) * np.sin(turn), tilt]
    )
    helper = np.array([1.0, 0, 0]) if abs(axis[0]) < 0.7 else np.array([0, 1.0, 0])
    u = np.cross(axis, helper) / np.linalg.norm(np.cross(axis, helper))
    rotation = np.stack([u, np.cross(axis, u), axis])
    shift = np.random.default_rng(seed).uniform(-50, 50, 3)
    flat = place(Bezier(ARCH), 40, np.radians(20))
    tilted = place(
        Bezier(np.array(ARCH) @ rotation + shift), 40, np.radians(20), legs=("parallel", axis)
    )
    assert np.degrees(tilted.thetas) == pytest.approx(np.degrees(flat.thetas), abs=1e-6)
    assert tilted.points == pytest.approx(flat.points @ rotation + shift, abs=1e-6)


class OnSphere:
    """A wavy curve on the sphere of radius 120 about the origin."""

    def point(self, s):
        t = np.asarray(s, float) * 1.8
        p = np.stack([np.cos(t), np.sin(t), 0.4 * np.sin(2 * t)], -1)
        return 120 * p / np.linalg.norm(p, axis=-1, keepdims=True)


@pytest.mark.parametrize("pitch", [0.0, 1.8])
def test_sphere_corners_lie_on_the_outer_sphere(pitch):
    placed = place(OnSphere(), 40, np.radians(20), pitch, legs=("point", (0, 0, 0)))
    omega = np.arctan(2 * 120 / 40)
    corners = np.linalg.norm(placed.segments, axis=-1)
    assert corners == pytest.approx(np.full(corners.shape, 40 / (2 * np.cos(omega))), rel=1e-9)
    assert len(placed) > 10


def test_thick_placement_leaves_room_for_the_double_hinge():
    """Between consecutive joint axes (p off the blocks) lies the link of length 2p."""
    pitch = 1.8
    placed = place(Bezier(ARCH), 40, np.radians(20), pitch)
    normal = np.cross(placed.reaches / 20, (0, 0, 1))
    ahead = np.diff(placed.midpoints, axis=0)
    for k in range(len(placed)):
        n, m = normal[k] * np.sign(normal[k] @ ahead[k]), normal[k + 1]
        m = m * np.sign(m @ ahead[k])
        here = placed.segments[k, 1] + pitch * n
        there = placed.segments[k + 1, 0] - pitch * m
        assert np.linalg.norm(there - here) == pytest.approx(2 * pitch, rel=1e-9)


def test_flip_side_starts_on_the_other_side():
    a = place(Bezier(ARCH), 40, np.radians(20))
    b = place(Bezier(ARCH), 40, np.radians(20), flip=True)
    assert a.sides[0] == -b.sides[0]


def test_starts_on_the_concave_side_and_left_where_straight():
    assert place(Bezier(ARCH), 40, np.radians(20)).sides[0] == -1  # the arch turns right
    assert place(Bezier([(0, 0), (200, 0)]), 25, np.radians(20)).sides[0] == 1


HAIRPIN = [(0, 0), (20, 100), (30, 100), (40, 0)]
LOOP = [(0, 0), (300, 300), (-250, 300), (60, 0)]


@pytest.mark.parametrize(
    ("points", "edge", "gamma", "options", "words"),
    [
        (ARCH, 40, 0, {}, "Gamma is 0°.*above 0°"),
        (ARCH, 40, 90, {}, "Gamma is 90°.*below 90°"),
        (ARCH, 40, np.nan, {}, "Gamma is nan"),
        (ARCH, 0, 20, {}, "EdgeLength.*above 0"),
        (ARCH, np.inf, 20, {}, "EdgeLength.*inf"),
        (ARCH, 700, 20, {}, "EdgeLength.*too long.*316"),
        (ARCH, 0.005, 20, {}, "more than 20000 units"),
        (ARCH, 40, 20, {"pitch": -1}, "Thickness.*-1"),
        (ARCH, 40, 20, {"pitch": 11}, "Thickness.*quarter"),
        (ARCH, 40, 20, {"legs": ("sideways", (0, 0, 1))}, "Ruling"),
        (ARCH, 40, 20, {"legs": ("parallel", (0, 0, 0))}, "Ruling"),
        (ARCH, 40, 20, {"legs": ("parallel", (1, 2, 0))}, "along the curve at its start"),
        ([*ARCH, (0, 0, 0)], 40, 20, {}, r"closed at \(0, 0, 0\)"),
        (HAIRPIN, 30, 20, {}, r"radius of curvature is too small near \(.*more than 15 mm"),
        (LOOP, 30, 20, {}, "tube meets itself: unit .* overlaps unit"),
    ],
)
def test_refusals_name_place_and_cure(points, edge, gamma, options, words):
    with pytest.raises(ValueError, match=words):
        place(Bezier(points), edge, np.radians(gamma), **options)


class Helix:
    def __init__(self, pitch, turns):
        self.pitch, self.turns = pitch, turns

    def point(self, s):
        t = np.asarray(s, float) * self.turns * 2 * np.pi
        return np.stack([100 * np.cos(t), 100 * np.sin(t), self.pitch * t / (2 * np.pi)], -1)


@pytest.mark.parametrize("pitch", [38, 42, 46, 50])
def test_level_rule_follows_a_helix_without_tilting(pitch):
    curve = Helix(pitch, 3)
    placed = place(curve, 30, np.radians(20), level=True)
    mids = (placed.points[:-1] + placed.points[1:]) / 2
    assert np.abs(curve.point(placed.parameters) - mids).max() < 0.1  # mm
    lengths = np.linalg.norm(np.diff(placed.points, axis=0), axis=1)
    assert lengths == pytest.approx(np.full(len(lengths), 30), rel=5e-3)
    climb = np.abs(np.diff(placed.points[:, 2])) / lengths
    assert climb.max() < np.sin(np.radians(6))


def test_level_rule_on_a_plane_curve_changes_nothing():
    a = place(Bezier(ARCH), 40, np.radians(20))
    b = place(Bezier(ARCH), 40, np.radians(20), level=True)
    assert b.points == pytest.approx(a.points, abs=1e-9)


def test_level_rule_needs_a_direction():
    with pytest.raises(ValueError, match="switch Level off"):
        place(OnSphere(), 40, np.radians(20), legs=("point", (0, 0, 0)), level=True)
