# SPDX-License-Identifier: LGPL-2.1-or-later
"""Angles of the triangular building blocks: equations (1)-(4) of the paper, in closed form.

Everything follows from the apex angle θ of the deployed base and the *ratio* c = ‖A'C'‖/‖AB‖.
Errata of the paper that matter here: β starts at π/4 − α/2 (not π/4 − α); the second triangle
needs tan α · tan β < 1/2; the numerator of (4) needs β' (not β).
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import require

MAX_SPHERE_THETA = np.pi / 3
# Room for rounding at the closed ends of the ranges; far below anything that can be built.
_SLACK = 1e-12


def half_opening(theta: NDArray) -> NDArray | float:
    """sin(θ/2): half the distance of the two A in units of ‖AB‖, and the smallest ratio.

    ``theta`` in radians, scalar or array; ValueError outside 0 < θ < π.
    """
    theta = np.asarray(theta, float)
    require(
        np.isfinite(theta) & (theta > 0) & (theta < np.pi),
        "Opening angle theta{at} is {value:.6g}°: it must lie between 0° and 180°.",
        np.degrees(theta),
    )
    return np.sin(theta / 2)


def angles_for(
    theta: NDArray | float, ratio: NDArray | float, dart: NDArray | float | None = None
) -> tuple:
    """Angles of the two triangles of a plane unit.

    Parameters: ``theta`` (radians) and ``ratio`` c = ‖A'C'‖/‖AB‖, scalars or arrays that
    broadcast; ``dart`` = √(c² − σ) where it is known better than its rounded difference.
    Returns ``(alpha, beta, beta_prime)`` of that shape, radians: the closed form that solves (2),
    (3) and the corrected (4). ValueError outside sin(θ/2) ≤ ratio < 1.
    """
    theta, c = np.broadcast_arrays(np.asarray(theta, float), np.asarray(ratio, float))
    sigma = half_opening(theta) ** 2
    low = np.sqrt(sigma)
    require(
        np.isfinite(c) & (c >= low - _SLACK) & (c < 1),
        "{Ratio}{at} is {value:.6g}: for theta {0:.4g}° it must be at least sin(theta/2) = "
        "{1:.6g} and below 1; change {Ratio} or make theta smaller (shorter edge or smaller "
        "{Gamma}).",
        c,
        np.degrees(theta),
        low,
        parameter="Ratio",
    )
    # cos² α = 2 [(c + σ) + √((1 − σ)(c² − σ))] / (1 + c)²; all the rest without cancellation.
    long = np.sqrt(1 - sigma)
    short = dart_length(theta, c) if dart is None else dart
    cos_alpha = np.sqrt(2 * ((c + sigma) + long * short)) / (1 + c)
    sin_alpha = (1 - c) / (long + short)
    b = apex_distance(cos_alpha, c)
    alpha = np.arctan2(sin_alpha, cos_alpha)
    beta = np.arctan2(b, long)
    beta_prime = np.arctan2(2 * c, (long + short) * cos_alpha)
    return alpha[()], beta[()], beta_prime[()]


def dart_length(theta: NDArray, ratio: Any) -> NDArray | float:
    """√(c² − σ): where C' lies between the two A of the deployed base, in units of ‖AB‖."""
    return np.sqrt(np.clip(ratio * ratio - np.sin(theta / 2) ** 2, 0, None))


def exact_dart(theta: NDArray) -> NDArray | float:
    """`dart_length` for `exact_sphere_ratio`, exact up to θ = 60° where it is 0."""
    sigma = np.sin(theta / 2) ** 2
    return np.clip(np.sqrt(1 - sigma) * (1 - 4 * sigma) / (3 - 4 * sigma), 0, None)


def apex_distance(cos_alpha: NDArray | float, ratio: NDArray | float) -> NDArray | float:
    """b = ‖AC‖ = ‖AP‖ in units of ‖AB‖: half of (1 + c) cos α."""
    return (1 + ratio) * cos_alpha / 2


def theta_for(alpha: NDArray | float, beta: NDArray | float) -> NDArray | float:
    """Opening angle θ of equation (3), radians; the range of (α, β) is the corrected one.

    ``alpha``, ``beta`` in radians, scalars or arrays that broadcast. ValueError where
    0 < α < π/2 and π/4 − α/2 ≤ β < π/2 − α do not hold, or tan α · tan β ≥ 1/2 (no dart).
    """
    alpha, beta = np.broadcast_arrays(np.asarray(alpha, float), np.asarray(beta, float))
    require(
        np.isfinite(alpha) & (alpha > 0) & (alpha < np.pi / 2),
        "Angle alpha{at} is {value:.6g}°: it must lie between 0° and 90°.",
        np.degrees(alpha),
    )
    low, high = np.pi / 4 - alpha / 2, np.pi / 2 - alpha
    require(
        np.isfinite(beta) & (beta >= low - _SLACK) & (beta < high),
        "Angle beta{at} is {value:.6g}°: for alpha {0:.4g}° it must be at least 45° - alpha/2 = "
        "{1:.6g}° and below 90° - alpha = {2:.6g}°.",
        np.degrees(beta),
        np.degrees(alpha),
        np.degrees(low),
        np.degrees(high),
    )
    product = np.tan(alpha) * np.tan(beta)
    require(
        product <= 0.5 + _SLACK,
        "tan(alpha)*tan(beta){at} is {value:.6g}: it must be below 1/2, or the second triangle "
        "has no dart; make alpha or beta smaller.",
        product,
    )
    # 1 − cos² β / sin²(α + β) = −cos α cos(α + 2β) / sin²(α + β), without cancellation.
    square = -np.cos(alpha) * np.cos(alpha + 2 * beta) / np.sin(alpha + beta) ** 2
    return (2 * np.arcsin(np.sqrt(np.clip(square, 0, 1))))[()]


def beta_prime_for(alpha: NDArray | float, beta: NDArray | float) -> NDArray | float:
    """β' of equation (2); radians in and out, broadcasting."""
    alpha, beta = np.asarray(alpha, float), np.asarray(beta, float)
    return np.arctan(np.sin(beta) / (np.cos(beta + alpha) * np.cos(alpha)) - np.tan(alpha))[()]


def ratio_for(alpha: NDArray | float, beta: NDArray | float) -> NDArray | float:
    """c = ‖A'C'‖/‖AB‖ of the corrected equation (4): ‖AC‖ sin β' / sin(α + β')."""
    alpha, beta = np.asarray(alpha, float), np.asarray(beta, float)
    beta_prime = beta_prime_for(alpha, beta)
    b = np.sin(beta) / np.sin(alpha + beta)
    return (b * np.sin(beta_prime) / np.sin(alpha + beta_prime))[()]


def exact_sphere_ratio(theta: NDArray | float) -> NDArray | float:
    """Ratio with which a spherical unit closes exactly: c = 1/(3 − 4 sin²(θ/2)).

    ``theta`` in radians; ValueError outside 0 < θ ≤ π/3. At 60° it is the paper's 1/2.
    """
    theta = np.asarray(theta, float)
    check_sphere_theta(theta)
    return (1 / (3 - 4 * np.sin(theta / 2) ** 2))[()]


def check_sphere_theta(theta: NDArray) -> None:
    """ValueError where a spherical unit's θ is not within 0 < θ ≤ 60° (section 4)."""
    theta = np.asarray(theta, float)
    require(
        np.isfinite(theta) & (theta > 0) & (theta <= MAX_SPHERE_THETA + _SLACK),
        "Opening angle theta{at} is {value:.6g}°: on a sphere it must be above 0° and below 60°; "
        "use a smaller {Gamma}, a shorter {EdgeLength} or a gentler curve.",
        np.degrees(theta),
        parameter="Gamma",
    )
