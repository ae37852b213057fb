"""Plane and spherical units: two congruent states, by the closed forms."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from BistableWB.origami import unit as units
from BistableWB.origami.units.creases import BODIES, CREASES, INDEX, PANELS, VERTICES, layer_of

THETAS = st.floats(1, 150).map(np.radians)
SPHERE_THETAS = st.floats(1, 60).map(np.radians)


def distance(points, a, b):
    return np.linalg.norm(points[INDEX[a]] - points[INDEX[b]])


@given(THETAS, st.floats(0.0, 0.98), st.floats(5, 500), st.floats(0.5, 8))
def test_plane_unit_is_isometric(theta, share, edge, height_ratio):
    low = np.sin(theta / 2)
    unit = units.plane_unit(theta, low + share * (1 - low), edge, edge / height_ratio)
    assert unit.isometry_error() <= 1e-12
    assert np.ptp(unit.flat[:, 1]) == 0
    assert distance(unit.deployed, "A_left_upper", "A_right_upper") == pytest.approx(
        2 * edge * low, rel=1e-12
    )


@given(SPHERE_THETAS, st.floats(60, 88).map(np.radians), st.floats(2.5, 8))
def test_exact_sphere_unit_is_isometric_and_lies_on_its_spheres(theta, omega, height_ratio):
    unit = units.sphere_unit(theta, 40, omega, 40 / height_ratio)
    assert unit.isometry_error() <= 1e-12
    centre = centre_of(unit.deployed)
    outer = [np.linalg.norm(unit.deployed[INDEX[v]] - centre) for v in CORNERS]
    assert outer == pytest.approx([40 / (2 * np.cos(omega))] * 3, rel=1e-9)


CORNERS = ("B_upper", "A_left_upper", "A_right_upper")


def centre_of(points):
    """Where the legs at B and at A_left meet."""
    b, a = points[INDEX["B_upper"]], points[INDEX["A_left_upper"]]
    leg_b, leg_a = b - points[INDEX["B_lower"]], a - points[INDEX["A_left_lower"]]
    along = np.linalg.lstsq(np.stack([leg_b, -leg_a], 1), a - b, rcond=None)[0]
    return b + along[0] * leg_b


def test_contact_legs_meet_in_v():
    unit = units.sphere_unit(np.radians(45), 40, np.radians(75), 16)
    centre = centre_of(unit.deployed)
    for name in ("B", "A_left", "A_right", "C"):
        upper, lower = unit.deployed[INDEX[f"{name}_upper"]], unit.deployed[INDEX[f"{name}_lower"]]
        assert np.linalg.norm(np.cross(upper - centre, lower - centre)) < 1e-9 * 75**2
    mid = (unit.deployed[INDEX["A_left_upper"]] + unit.deployed[INDEX["B_upper"]]) / 2
    assert np.linalg.norm(mid - centre) == pytest.approx(units.contact_radius(40, np.radians(75)))


def test_paper_rule_reports_its_residual():
    unit = units.sphere_unit(np.radians(50), 40, np.radians(70), 12, rule="paper")
    assert unit.residual() == pytest.approx(0.0125, abs=5e-4)
    assert unit.isometry_error() >= unit.residual()
    at_80 = units.sphere_unit(np.radians(50), 40, np.radians(80), 12, rule="paper")
    at_85 = units.sphere_unit(np.radians(50), 40, np.radians(85), 12, rule="paper")
    assert (at_80.residual(), at_85.residual()) == pytest.approx((0.0029, 0.0007), abs=5e-5)
    at_60 = units.sphere_unit(np.radians(60), 40, np.radians(70), 12, rule="paper")
    assert at_60.isometry_error() < 1e-8  # c² − σ = 0 there: a rounding error counts as its root


def test_flat_order_and_dart():
    unit = units.plane_unit(np.radians(45), 0.42, 1, 0.4)
    a, c, b = (unit.flat[INDEX[v], 0] for v in ("A_left_upper", "C_upper", "B_upper"))
    assert a < c < b
    deployed = unit.deployed
    assert 0 < deployed[INDEX["C_upper"], 0] < deployed[INDEX["B_upper"], 0]
    assert deployed[INDEX["A_left_upper"], 1] < 0 < deployed[INDEX["A_right_upper"], 1]


def test_batch_equals_single_units():
    thetas = np.radians([30.0, 40.0, 50.0])
    batch = units.plane_unit(thetas, 0.5, 40, 16)
    assert batch.flat.shape == (3, 10, 3)
    for k, theta in enumerate(thetas):
        one = units.plane_unit(theta, 0.5, 40, 16)
        assert batch[k].deployed == pytest.approx(one.deployed, abs=0)
    sphere = units.sphere_unit(thetas, 40, np.radians(80), 16)
    assert sphere[1].flat == pytest.approx(
        units.sphere_unit(thetas[1], 40, np.radians(80), 16).flat, abs=1e-13
    )


def test_crease_table_counts_and_layers():
    assert len(VERTICES) == 10
    assert len(PANELS) == 12
    assert len(BODIES) == 15
    assert len(CREASES) == 23
    assert sum(c.double for c in CREASES) == 6
    for crease in CREASES:
        panels = [b for b in crease.bodies if b in PANELS]
        for panel in panels:  # a hinge lies on an edge of both its panels
            assert set(crease.vertices) <= set(PANELS[panel])
        layers = {layer_of(p) for p in panels}
        heights = {h - 2.5 for h in layers}  # mid-planes in pitches
        assert all(abs(h - crease.height) == 0.5 for h in heights)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: units.plane_unit(0.8, 0.5, -1, 16), "EdgeLength.*above 0"),
        (lambda: units.plane_unit(0.8, 0.5, np.nan, 16), "EdgeLength.*nan"),
        (lambda: units.plane_unit(0.8, 0.5, 40, 0), "Strip height.*HeightRatio"),
        (lambda: units.sphere_unit(0.8, 40, np.radians(91), 10), "omega.*between 0° and 90°"),
        (lambda: units.sphere_unit(0.8, 40, np.radians(30), 15), "Strip height.*raise HeightRatio"),
        (lambda: units.sphere_unit(1.1, 40, np.radians(80), 15), "theta.*below 60°"),
        (lambda: units.sphere_unit(0.8, 40, np.radians(80), 15, rule="x"), "rule 'x' is unknown"),
    ],
)
def test_refusals(call, words):
    with pytest.raises(ValueError, match=words):
        call()
