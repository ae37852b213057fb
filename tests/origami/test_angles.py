"""Equations (1)-(4), their corrected ranges and the reference numbers."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from BistableWB.origami.units import angles

THETAS = st.floats(0.5, 170).map(np.radians)
SHARES = st.floats(0.0, 0.999)  # how far the ratio lies between sin(theta/2) and 1


def ratio_between(theta, share):
    low = np.sin(theta / 2)
    return low + share * (1 - low)


def test_reference_angles(vectors):
    for row in vectors["angles"]:
        found = np.degrees(angles.angles_for(np.radians(row["theta"]), row["ratio"]))
        assert found == pytest.approx([row["alpha"], row["beta"], row["beta_prime"]], abs=1e-6)


def test_reference_sphere_ratios(vectors):
    for row in vectors["sphere_exact_ratio"]:
        assert angles.exact_sphere_ratio(np.radians(row["theta"])) == pytest.approx(
            row["ratio"], abs=1e-11
        )


@given(THETAS, st.floats(0.001, 0.999))
def test_equations_1_to_4_hold(theta, share):
    ratio = ratio_between(theta, share)
    alpha, beta, beta_prime = angles.angles_for(theta, ratio)
    square = 1 - (np.cos(beta) / np.sin(alpha + beta)) ** 2  # (1)
    assert square == pytest.approx(np.sin(theta / 2) ** 2, abs=1e-12)
    assert angles.beta_prime_for(alpha, beta) == pytest.approx(beta_prime, abs=1e-12)  # (2)
    assert np.sin(angles.theta_for(alpha, beta) / 2) == pytest.approx(
        np.sin(theta / 2), abs=1e-12
    )  # (3)
    assert angles.ratio_for(alpha, beta) == pytest.approx(ratio, abs=1e-12)  # corrected (4)


@given(THETAS, SHARES)
def test_ranges_are_the_corrected_ones(theta, share):
    alpha, beta, _ = angles.angles_for(theta, ratio_between(theta, share))
    assert np.pi / 4 - alpha / 2 <= beta + 1e-12
    assert beta < np.pi / 2 - alpha
    assert np.tan(alpha) * np.tan(beta) <= 0.5 + 1e-9


def test_arrays_and_scalars_agree():
    theta, ratio = np.radians([20.0, 45.0, 60.0]), np.array([0.3, 0.5, 0.7])
    batch = np.array(angles.angles_for(theta, ratio))
    single = np.array([angles.angles_for(t, c) for t, c in zip(theta, ratio, strict=True)]).T
    assert batch == pytest.approx(single, abs=0)
    assert np.ndim(angles.angles_for(theta[0], 0.5)[0]) == 0


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: angles.angles_for(np.radians(45), 0.3), "Ratio is 0.3.*at least .*0.382683"),
        (lambda: angles.angles_for(np.radians(45), 1.0), "Ratio is 1.*below 1"),
        (lambda: angles.angles_for(np.radians(45), np.nan), "Ratio is nan"),
        (lambda: angles.angles_for(np.radians([40, 80]), 0.5), "Ratio of unit 2"),
        (lambda: angles.angles_for(0.0, 0.5), "theta is 0°.*between 0° and 180°"),
        (lambda: angles.angles_for(np.pi, 0.5), "theta is 180°"),
        (lambda: angles.theta_for(np.radians(30), np.radians(29)), "beta is 29°.*45° - alpha/2"),
        (lambda: angles.theta_for(np.radians(30), np.radians(61)), "beta is 61°.*below"),
        (lambda: angles.theta_for(np.radians(40), np.radians(45)), "tan.alpha..tan.beta.*1/2"),
        (lambda: angles.theta_for(np.radians(-1), np.radians(45)), "alpha is -1°"),
        (lambda: angles.exact_sphere_ratio(np.radians(61)), "theta is 61°.*below 60°"),
        (lambda: angles.exact_sphere_ratio(0.0), "theta is 0°"),
    ],
)
def test_refusals_name_the_parameter_and_the_range(call, words):
    with pytest.raises(ValueError, match=words):
        call()


def test_printed_lower_end_of_beta_is_refused():
    """The paper prints π/4 − α; between that and π/4 − α/2 equation (1) is not real."""
    alpha = np.radians(30)
    with pytest.raises(ValueError, match="beta"):
        angles.theta_for(alpha, np.radians(20))
