# SPDX-License-Identifier: LGPL-2.1-or-later
"""General units: plane and sphere as special cases, any curve in space, and clear refusals."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from BistableWB.origami.curves.bezier import Bezier
from BistableWB.origami.curves.placement import place
from BistableWB.origami.unit import PANELS, VERTICES, plane_unit, sphere_unit
from BistableWB.origami.units import angles, general
from BistableWB.origami.units.contacts import contact_pairs
from BistableWB.origami.units.general import general_unit
from BistableWB.origami.units.shape import check_shape

INDEX = {name: i for i, name in enumerate(VERTICES)}
NAMES = ("flat", "theta", "ratio", "alpha", "beta", "beta_prime")
RISING = Bezier([[0, 0, 0], [60, 120, 20], [180, 120, 60], [240, 0, 70]])
few = settings(max_examples=12, deadline=None, derandomize=True)


def contacts_of(unit):
    return tuple(
        unit.deployed[..., [INDEX[v] for v in PANELS[f"contact_{side}"]], :]
        for side in ("left", "right")
    )


def rotation(seed):
    q, r = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    q *= np.sign(np.diag(r))
    return q * np.linalg.det(q)


def oblique_contacts(theta, left, right, height):
    """Parallelograms about the z axis that rise by the angles ``left`` and ``right`` towards A."""
    quads = []
    for side, tilt in ((-1, left), (1, right)):
        a = np.array(
            [
                -np.cos(tilt) * np.cos(theta / 2),
                side * np.cos(tilt) * np.sin(theta / 2),
                np.sin(tilt),
            ]
        )
        up = np.array([0, 0, height / 2])
        quads.append(np.array([a + up, up, -up, a - up]))
    return quads


def assert_same(found, expected, deployed, tolerance=1e-9):
    for name in NAMES:
        np.testing.assert_allclose(
            getattr(found, name), getattr(expected, name), rtol=0, atol=tolerance, err_msg=name
        )
    for name in ("edge_length", "strip_height", "omega"):
        figure = getattr(expected, name)
        assert getattr(found, name) == (figure if figure is None else pytest.approx(figure)), name
    np.testing.assert_allclose(found.deployed, deployed, rtol=0, atol=tolerance)


# ---------------------------------------------------------------- special cases


@few
@given(st.floats(2, 100), st.floats(0.02, 0.95), st.floats(0.1, 2), st.integers(0, 99))
def test_plane_contacts_give_the_plane_unit(theta, above, height, seed):
    theta = np.radians(theta)
    ratio = np.sin(theta / 2) + above * (1 - np.sin(theta / 2))
    unit = plane_unit(theta, ratio, 1.0, height)
    turn, shift = rotation(seed), np.array([3.0, -2.0, 5.0])
    found = general_unit(*(q @ turn.T + shift for q in contacts_of(unit)), ratio)
    assert_same(found, unit, unit.deployed @ turn.T + shift)
    assert found.isometry_error() <= 1e-12


@few
@given(st.floats(5, 59.5), st.floats(60, 88), st.floats(0.1, 0.8), st.integers(0, 99))
def test_sphere_contacts_give_the_sphere_unit(theta, omega, height, seed):
    theta, omega = np.radians([theta, omega])
    unit = sphere_unit(theta, 1.0, omega, height)
    turn, shift = rotation(seed), np.array([3.0, -2.0, 5.0])
    quads = (q @ turn.T + shift for q in contacts_of(unit))
    found = general_unit(*quads, angles.exact_sphere_ratio(theta))
    assert_same(found, unit, unit.deployed @ turn.T + shift)


def test_sphere_contacts_close_with_any_ratio():
    theta = np.radians([20.0, 35.0, 55.0])
    unit = sphere_unit(theta, 40.0, np.radians(75), 16.0)
    for ratio in (0.5, 0.65, 0.8):
        found = general_unit(*contacts_of(unit), ratio)
        assert found.isometry_error().max() <= 1e-12
        np.testing.assert_allclose(found.ratio, ratio, atol=0.03)


def test_both_contacts_oblique_alike_need_no_iteration():
    quads = oblique_contacts(np.radians(40), np.radians(25), np.radians(25), 0.4)
    normalised, _, _ = general.normalised_contacts(*quads)
    _, deployed, flat = general.symmetric_start(normalised, np.array([0.6]))
    residual, _ = general._equations(deployed, flat)
    assert np.abs(residual).max() < 1e-13


def test_mirrored_contacts_give_the_mirrored_unit():
    unit = plane_unit(np.radians(40), 0.6, 40.0, 16.0)
    mirror = np.array([1, -1, 1])
    found = general_unit(*(q * mirror for q in contacts_of(unit)), 0.6)
    np.testing.assert_allclose(found.deployed, unit.deployed * mirror, atol=1e-9)
    np.testing.assert_allclose(found.flat, unit.flat, atol=1e-9)


# ---------------------------------------------------------------- the solver


def test_jacobian_is_the_derivative_on_the_solutions():
    quads = oblique_contacts(np.radians(40), np.radians(-10), np.radians(20), 0.4)
    normalised, _, _ = general.normalised_contacts(*quads)
    _, deployed, flat = general.symmetric_start(normalised, np.array([0.6]))
    general.solve(deployed, flat)
    _, jacobian = general._equations(deployed, flat)
    for column in range(32):
        moved = []
        for step in (1e-6, -1e-6):
            d, f = deployed.copy(), flat.copy()
            if column < 12:
                d[0, general._FREE[column // 3], column % 3] += step
            else:
                f[0, (column - 12) // 2, column % 2] += step
            moved.append(general._equations(d, f)[0][0])
        np.testing.assert_allclose(
            jacobian[0, :, column], (moved[0] - moved[1]) / 2e-6, atol=1e-7, rtol=1e-7
        )
    singular = np.linalg.svd(jacobian[0], compute_uv=False)
    assert (singular > 1e-3 * singular[0]).sum() == 24


def test_a_batch_is_its_units_one_by_one():
    left, right = contact_pairs(place(RISING, 40.0, np.radians(20)), 16.0)
    batch = general_unit(left, right, 0.6)
    assert len(batch) == len(left)
    for k in (0, 7, 21):
        single = general_unit(left[k], right[k], 0.6)
        np.testing.assert_allclose(single.deployed, batch.deployed[k], atol=1e-9)
        np.testing.assert_allclose(single.flat, batch.flat[k], atol=1e-9)
        assert single.theta == pytest.approx(batch.theta[k])


# ---------------------------------------------------------------- refusals


def good_contacts(n=3):
    return [np.array(q) for q in contacts_of(plane_unit(np.full(n, 0.7), 0.6, 40.0, 16.0))]


def skewed(quads):
    left, right = quads
    across = right[1, 3] - right[1, 2]
    right[1, 0] += 0.1 * across  # still planar, but its leg no longer parallel
    return left, right


def not_planar(quads):
    quads[0][1, 0] += [0, 0.1, 0.1]
    return quads


def apart(quads):
    quads[1][1, 1:3] += [0.1, 0, 0]
    return quads


def crossed(quads):
    quads[0][1, [0, 3]] = quads[0][1, [3, 0]]
    return quads


def collapsed(quads):
    quads[0][1, 0] = quads[0][1, 1]
    quads[1][1, 0] = quads[1][1, 1]
    return quads


def infinite(quads):
    quads[0][1, 0, 0] = np.inf
    return quads


def closed(quads):
    quads[1][1] = quads[0][1]
    return quads


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (skewed, "neither parallel nor all through one point"),
        (not_planar, "not planar"),
        (apart, "do not share the leg at B"),
        (crossed, "not convex"),
        (collapsed, "corners coincide"),
        (infinite, "finite"),
        (closed, "opening must lie between"),
    ],
)
def test_bad_contacts_are_refused_with_the_unit_named(spoil, words):
    with pytest.raises(ValueError, match=words) as error:
        general_unit(*spoil(good_contacts()), 0.6)
    assert "unit 2" in str(error.value)


def test_shapes_and_ratio_are_checked():
    left, right = good_contacts()
    with pytest.raises(ValueError, match="shape"):
        general_unit(left, right[0], 0.6)
    with pytest.raises(ValueError, match="no unit"):
        general_unit(left[:0], right[:0], 0.6)
    with pytest.raises(ValueError, match="Ratio of unit 3"):
        general_unit(left, right, np.array([0.6, 0.6, 0.2]))


def test_too_oblique_contacts_are_refused():
    for tilt in (60, 75, 85):
        quads = oblique_contacts(np.radians(20), np.radians(-tilt), np.radians(tilt), 0.4)
        with pytest.raises(ValueError, match="unit 1"):
            general_unit(*quads, 0.5)


def test_flipped_and_reordered_shapes_are_refused():
    good = plane_unit(np.full(2, 0.7), 0.6, 1.0, 0.4)
    for state, name, move, words in (
        ("flat", "C_upper", (0.5, 0, 0), "between A and B"),
        ("flat", "P_upper", (0, 0, -0.6), "flipped"),
        ("deployed", "P_upper", (0, 0, -0.9), "inside out"),
        ("deployed", "C_upper", (-0.6, 0, 0), "inside out"),
    ):
        states = {"flat": good.flat.copy(), "deployed": good.deployed.copy()}
        states[state][1, INDEX[name]] += move
        with pytest.raises(ValueError, match=words) as error:
            check_shape(states["deployed"], states["flat"])
        assert "unit 2" in str(error.value)
