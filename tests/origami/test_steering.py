# SPDX-License-Identifier: LGPL-2.1-or-later
"""Zigzags that meet both ends, and closed ones, on every family, thin and thick."""

import time
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapes import ARCH, ESS, Bend, Heart, OnSphere, OnSphereRing, Random, Ring, Rising

from BistableWB.origami import rigid
from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.corners import Rounded
from BistableWB.origami.curves.placement import place
from BistableWB.origami.curves.rules import END_FIT, STEERED, PlacementRule
from BistableWB.origami.errors import Refusal
from BistableWB.origami.thick.thick_tube import block_lines, thick_tube
from BistableWB.origami.units import tube as tubes
from BistableWB.origami.units.ratios import RatioRule

GAMMA = np.radians(20)
CENTRE = ("point", (0, 0, 0))
UP = ("parallel", (0, 0, 1))
FAMILIES = [
    (ARCH, None, "Plane", None),
    (OnSphere(), CENTRE, "Sphere", 300.0),
    (Rising(), UP, "General", None),
]


def check_zigzag(placed, pitch=0.0):
    """The rule of `placement` between neighbours, by mirrors: no formula of the march is used."""
    normals = np.cross(placed.reaches, placed.legs)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    ahead = np.diff(placed.midpoints, axis=0)
    for k, travel in enumerate(ahead):
        y = travel / np.linalg.norm(travel)
        mirrored = placed.reaches[k] - 2 * (placed.reaches[k] @ y) * y
        assert -mirrored == pytest.approx(placed.reaches[k + 1], abs=1e-6 * placed.edge_length)
        here = normals[k] * np.sign(normals[k] @ y)
        there = normals[k + 1] * np.sign(normals[k + 1] @ y)
        joint = placed.midpoints[k] + placed.reaches[k] + pitch * here
        other = placed.midpoints[k + 1] - placed.reaches[k + 1] - pitch * there
        assert other - joint == pytest.approx(2 * pitch * y, abs=1e-6)


def distance(curve, points):
    """Distance of points from a curve, by brute force."""
    dense = curve.point(np.linspace(0, 1, 20001))
    return np.array([np.linalg.norm(dense - p, axis=1).min() for p in points])


@pytest.mark.parametrize(("curve", "legs", "family", "radius"), FAMILIES)
@pytest.mark.parametrize("pitch", [0.0, 1.8])
def test_end_fit_ends_at_the_end_with_midpoints_on_the_curve(curve, legs, family, radius, pitch):
    placed = place(curve, 40, GAMMA, pitch, legs, rule=END_FIT)
    end = curve.point(np.array([1.0]))[0]
    assert np.linalg.norm(placed.midpoints[-1] - end) <= 1e-6 * 40
    assert placed.end_gap <= 1e-6 * 40
    assert distance(curve, placed.midpoints).max() < 0.02  # what 20,000 samples see
    assert abs(placed.gamma - GAMMA) < np.radians(2.5)
    assert placed.parameters[-1] == 1


@pytest.mark.slow
@given(st.integers(0, 10_000), st.floats(15, 30), st.sampled_from([0.0, 1.8]))
@settings(max_examples=6, deadline=None)
def test_end_fit_on_random_curves(seed, gamma, pitch):
    curve = Random(seed)
    placed = place(curve, 30, np.radians(gamma), pitch, rule=END_FIT)
    assert placed.end_gap <= 1e-6 * 30
    # it is the march with the gamma that was found
    march = place(curve, 30, placed.gamma, pitch)
    assert march.thetas[: len(placed) - 1] == pytest.approx(placed.thetas[:-1], abs=1e-4)


@pytest.mark.slow
@pytest.mark.parametrize("before", [200, 205, 210, 215, 220])
@pytest.mark.parametrize("pitch", [0.0, 1.8])
def test_steered_round_a_bend_theta_is_behind_it_what_it_was_before(before, pitch):
    curve = Bend(before)
    rule = PlacementRule("Steered", tolerance=0.12 * 40)
    placed = place(curve, 40, GAMMA, pitch, rule=rule)
    along = (placed.lengths[1:] + placed.lengths[:-1]) / 2
    degrees = np.degrees(placed.thetas)
    first, second = degrees[along < before - 20], degrees[along > curve.after + 20]
    assert abs(second.mean() - first.mean()) < 8
    assert distance(curve, placed.midpoints).max() <= 0.12 * 40
    assert placed.end_gap < 1e-6
    check_zigzag(placed, pitch)


@pytest.mark.parametrize("curve", [ARCH, ESS])
@pytest.mark.parametrize("edge", [40, 90])
@pytest.mark.parametrize("pitch", [0.0, 1.8])
def test_steered_arch_and_ess_stay_on_the_curve(curve, edge, pitch):
    rule = PlacementRule("Steered", tolerance=0.005 * edge)
    placed = place(curve, edge, GAMMA, pitch, rule=rule)
    assert distance(curve, placed.midpoints).max() <= 0.0051 * edge + 0.01
    assert placed.end_gap <= 1e-6 * edge
    assert placed.midpoints[0] == pytest.approx(curve.point(np.array([0.0]))[0], abs=1e-9)


def test_steering_a_hundred_units_takes_a_tenth_of_a_second():
    place(ARCH, 15, GAMMA, rule=STEERED)
    start = time.process_time()
    placed = place(ARCH, 15, GAMMA, rule=STEERED)
    assert len(placed) > 95
    assert time.process_time() - start < 0.1 * 3  # slower machines


def test_a_symmetric_tube_is_the_same_from_both_ends():
    placed = place(ARCH, 40, GAMMA, 1.8, rule=PlacementRule("Steered", symmetric=True))
    mirrored = placed.midpoints[::-1] * [-1, 1, 1] + [300, 0, 0]
    assert mirrored == pytest.approx(placed.midpoints, abs=1e-6)
    assert placed.thetas[::-1] == pytest.approx(placed.thetas, abs=1e-9)
    turned = place(ESS, 40, GAMMA, 1.8, rule=PlacementRule("Steered", symmetric=True))
    assert [300, 200, 0] - turned.midpoints[::-1] == pytest.approx(turned.midpoints, abs=1e-6)


def test_blocks_stand_square_at_the_ends_where_asked():
    rule = PlacementRule("Steered", tolerance=2.0, start="Square", end="Square")
    placed = place(ARCH, 40, GAMMA, 1.8, rule=rule)
    assert placed.reaches[0] @ [0, 1, 0] == pytest.approx(0, abs=1e-3)
    assert placed.reaches[-1] @ [0, 1, 0] == pytest.approx(0, abs=1e-3)


def test_a_curve_without_symmetry_is_steered_without_and_says_so():
    rule = PlacementRule("Steered", tolerance=2.0, symmetric=True)
    wished = place(Bend(120), 40, GAMMA, rule=rule)
    plain = place(Bend(120), 40, GAMMA, rule=replace(rule, symmetric=False))
    assert wished.unlike > 1
    assert wished.points == pytest.approx(plain.points)
    assert place(ARCH, 40, GAMMA, 1.8, rule=rule).unlike == 0


CLOSED = [
    ("circle", Ring(60), UP, "Plane", None, 30),
    ("wide circle", Ring(120), UP, "Plane", None, 40),
    ("ellipse", Ring(120, 80), UP, "Plane", None, 30),
    ("heart", Rounded(Heart(), Heart.kinks, 30), UP, "Plane", None, 24),
    ("loop in space", Ring(120, 120, 20), UP, "General", None, 40),
    ("ring on a sphere", OnSphereRing(), CENTRE, "Sphere", 150.0, 30),
]


def closed_tube(curve, legs, family, radius, edge, pitch=1.8, rule=END_FIT):
    ratio = RatioRule("Adaptive", share=0.05)
    return thick_tube(
        lambda tuning: place(
            curve,
            edge,
            GAMMA,
            pitch,
            legs,
            extra=tuning.extra,
            rule=replace(rule, near=tuning.near),
        ),
        lambda placed, tuning: tubes.along(placed, family, 2.5, ratio, radius, tuning),
        1.2,
        0.6,
    )


@pytest.mark.slow
@pytest.mark.parametrize(("name", "curve", "legs", "family", "radius", "edge"), CLOSED)
def test_the_end_panels_of_a_closed_tube_coincide_thick(name, curve, legs, family, radius, edge):
    tube = closed_tube(curve, legs, family, radius, edge)
    assert len(tube.tube) % 2 == 0
    assert tube.tube.unit.isometry_error().max() < 1e-11
    assert tube.thick.misfit(1.0).max() < 1e-6
    lines = rigid.apply(tube.onto_curve(), block_lines(tube.thick, tube.tube.incoming_left))
    assert np.abs(lines[0] - lines[-1]).max() < 1e-3
    assert distance(curve, lines.mean(1)).max() < 0.06 * edge


@pytest.mark.slow
@given(st.integers(0, 10_000), st.sampled_from([0.0, 25.0]))
@settings(max_examples=4, deadline=None)
def test_random_closed_curves_close(seed, height):
    placed = place(Random(seed, True, height), 30, GAMMA, 1.8, UP, rule=END_FIT)
    assert placed.closed
    assert placed.midpoints[-1] == pytest.approx(placed.midpoints[0], abs=1e-7)
    assert placed.reaches[-1] == pytest.approx(placed.reaches[0], abs=1e-7)
    assert len(placed) % 2 == 0


def refused(*given, **more):
    with pytest.raises(Refusal) as error:
        place(*given, **more)
    return error.value


def test_what_cannot_be_is_refused_with_place_parameter_and_cure():
    line = Bezier([(0, 0), (8, 0)])
    for rule in (END_FIT, STEERED):
        found = refused(line, 40, GAMMA, 1.8, rule=rule)
        assert found.parameter in ("EdgeLength", "PlacementRule", "Tolerance")
    found = refused(ARCH, 40, GAMMA, rule=PlacementRule("Steered", tolerance=0.0))
    assert (found.parameter, "EndFit" in str(found)) == ("Tolerance", True)
    found = refused(Ring(60), 40, GAMMA)
    assert found.parameter == "PlacementRule"
    found = refused(Ring(60, 25), 40, GAMMA, 1.8, rule=STEERED)
    assert "(" in str(found)
    assert "shorter" in str(found)
    away = Bezier([(10, 0, 0), (100, 0, 50), (200, 80, 0), (300, 0, 0)])
    assert refused(away, 40, GAMMA, legs=("point", (0, 200, 0)), rule=STEERED).parameter == "Ruling"
