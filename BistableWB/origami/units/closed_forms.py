# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two units with a closed form: plane (section 3.2 of the paper) and spherical (section 4).

`Unit` is the one class for these and for the general unit; they differ only in the function that
makes their two vertex sets. A `Unit` holds one unit or a batch: arrays are (10, 3) or (n, 10, 3).
"""

from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import Refusal, require
from . import angles
from .creases import INDEX, PANELS, VERTICES

# Every panel edge and every diagonal of a quadrilateral, as index pairs, each once.
BARS = np.array(
    sorted(
        {
            tuple(sorted((INDEX[a], INDEX[b])))
            for corners in PANELS.values()
            for a, b in combinations(corners, 2)
        }
    )
)

_EDGES = {
    tuple(sorted((INDEX[a], INDEX[b])))
    for corners in PANELS.values()
    for a, b in zip(corners, (*corners[1:], corners[0]), strict=True)
}
IS_EDGE = np.array([tuple(bar) in _EDGES for bar in BARS.tolist()])


Angle = NDArray | float  # radians, of one unit or of each of a batch


@dataclass(frozen=True)
class Unit:
    """Vertices of one unit (or a batch) in its own frame, rows in the order of `VERTICES`.

    ``flat``, ``deployed``: (…, 10, 3) in the unit of ``edge_length``; ``theta`` (radians),
    ``ratio``, ``alpha``, ``beta``, ``beta_prime``: scalars or arrays of the batch's shape;
    ``omega`` is the base angle of the contact trapezoids: None for a plane unit, else like theta.
    """

    flat: np.ndarray
    deployed: np.ndarray
    theta: np.ndarray
    ratio: np.ndarray
    alpha: np.ndarray
    beta: np.ndarray
    beta_prime: np.ndarray
    edge_length: float
    strip_height: float
    omega: np.ndarray | None = None

    def __len__(self) -> int:
        return self.flat.shape[0] if self.flat.ndim == 3 else 1

    def __getitem__(self, index: NDArray | int | slice | None) -> "Unit":
        """One unit, or a smaller batch, of a batch."""
        names: tuple[str, ...] = (
            "flat",
            "deployed",
            "theta",
            "ratio",
            "alpha",
            "beta",
            "beta_prime",
        )
        if self.omega is not None:
            names = (*names, "omega")
        return replace(self, **{name: getattr(self, name)[index] for name in names})

    def isometry_error(self) -> NDArray | float:
        """Largest relative change of any panel edge or diagonal between the two states."""
        before, after = bar_lengths(self.flat), bar_lengths(self.deployed)
        return (np.abs(after - before) / before).max(-1)[()]

    def residual(self) -> float:
        """Largest relative change of any panel *edge*: what the ratio rule leaves unclosed.

        For the paper's rule on a sphere this is the leg at C' (1.2 % at ω = 70°, θ = 50°).
        """
        before, after = (
            bar_lengths(self.flat)[..., IS_EDGE],
            bar_lengths(self.deployed)[..., IS_EDGE],
        )
        return (np.abs(after - before) / before).max(-1)[()]


def bar_lengths(points: NDArray) -> NDArray:
    """Lengths of all `BARS`: (…, 10, 3) → (…, bars)."""
    return np.linalg.norm(points[..., BARS[:, 0], :] - points[..., BARS[:, 1], :], axis=-1)


def plane_unit(
    theta: NDArray | float, ratio: NDArray | float | None, edge_length: float, strip_height: float
) -> Unit:
    """The plane unit of section 3.2: legs parallel, contact and border panels rectangles.

    ``theta`` radians and ``ratio`` c, scalars or (n,); ``edge_length`` ‖AB‖ and ``strip_height`` h
    in one unit of length. Returns a `Unit`, isometric to rounding. ValueError outside
    sin(θ/2) ≤ c < 1 or for lengths that are not positive.
    """
    _check_lengths(edge_length, strip_height)
    theta, ratio = np.broadcast_arrays(np.asarray(theta, float), np.asarray(ratio, float))
    found = angles.angles_for(theta, ratio)
    dart = angles.dart_length(theta, ratio)
    flat, deployed = _upper_pyramid(theta, ratio, found[0], dart)
    shift = np.array([0, 0, strip_height / 2])
    states: Any = [
        _with_lower(s * edge_length + shift, np.array([1, 1, -1.0])) for s in (flat, deployed)
    ]
    shape: Any = (*states, theta, ratio, *found, float(edge_length), float(strip_height))
    return Unit(*shape)


def sphere_unit(
    theta: Angle, edge_length: float, omega: Angle | None, strip_height: float, rule: str = "exact"
) -> Unit:
    """The spherical unit of section 4: legs meet at the sphere's centre V.

    ``theta`` radians, scalar or (n,); ``edge_length`` is the outer (upper) ‖AB‖; ``omega`` the base
    angle of the contact trapezoid, radians, scalar or (n,); ``strip_height`` h its height.
    ``rule``: "exact" takes c = 1/(3 − 4 sin²(θ/2)), which closes to rounding; "paper" takes
    c = 1/2, whose border legs change length (`Unit.isometry_error`). The lower (inner) sub-unit is
    the upper one mirrored in its base plane and scaled about V by 1 − h/r.
    ValueError outside 0 < θ ≤ 60°, 0 < ω < 90°, or where h leaves no inner base.
    """
    _check_lengths(edge_length, strip_height)
    theta = np.asarray(theta, float)
    omega = np.broadcast_to(np.asarray(omega, float), theta.shape)
    angles.check_sphere_theta(theta)
    _check_sphere_rule(rule)
    radius = contact_radius(edge_length, omega)
    require(
        strip_height < radius,
        "Strip height h = {value:.6g} is too large for omega {0:.4g}°: the inner base vanishes at "
        "{1:.6g}; raise {HeightRatio} or omega (a larger sphere).",
        strip_height,
        np.degrees(omega),
        radius,
        parameter="HeightRatio",
    )
    ratio = angles.exact_sphere_ratio(theta) if rule == "exact" else np.full_like(theta, 0.5)
    dart = angles.exact_dart(theta) if rule == "exact" else angles.dart_length(theta, ratio)
    found = angles.angles_for(theta, ratio, dart)
    r = radius / edge_length
    shift = np.array([0, 0, strip_height / 2])
    scale = np.asarray(1 - strip_height / radius)[..., None, None]
    # The centre V, seen from the base plane: in the flat state below the middle of A-B; deployed,
    # below the centre of the circle through A_left, B, A_right (radius 1 / (2 cos t)).
    t = theta / 2
    rho = 1 / (2 * np.cos(t))
    zero = np.zeros_like(theta)
    depth = np.sqrt(r * r + 0.25 - rho * rho)
    centres = (
        np.stack([zero + 0.5, zero, zero - r], -1),
        np.stack([np.cos(t) - rho, zero, -depth], -1),
    )
    states: Any = []
    for upper, centre in zip(_upper_pyramid(theta, ratio, found[0], dart), centres, strict=True):
        mirrored = upper * np.array([1, 1, -1.0])
        lower = centre[..., None, :] + scale * (mirrored - centre[..., None, :])
        states.append(_interleave(upper * edge_length + shift, lower * edge_length + shift))
    shape: Any = (*states, theta, ratio, *found, float(edge_length), float(strip_height), omega)
    return Unit(*shape)


def _check_sphere_rule(rule: str) -> None:
    if rule not in ("exact", "paper"):
        raise Refusal(
            "Ratio rule {rule!r} is unknown on a sphere: use 'exact' or 'paper'.",
            parameter="RatioRule",
            rule=rule,
        )


def contact_radius(edge_length: float, omega: NDArray) -> NDArray | float:
    """Radius r = (‖AB‖/2) tan ω of the sphere that carries the curve (midpoints of the A–B)."""
    require(
        np.isfinite(omega) & (omega > 0) & (omega < np.pi / 2),
        "Base angle omega is {value:.6g}°: it must lie between 0° and 90°.",
        np.degrees(omega),
    )
    return edge_length / 2 * np.tan(omega)


def outer_radius(edge_length: float, omega: Any) -> Any:
    """Radius R = ‖AB‖ / (2 cos ω) of the sphere that carries the outer corners."""
    return edge_length / (2 * np.cos(omega))


def _upper_pyramid(
    theta: NDArray, ratio: NDArray | float, alpha: NDArray | float, dart: NDArray | float
) -> tuple[NDArray, NDArray]:
    """Flat and deployed A_left, A_right, B, C', P of one sub-unit for ‖AB‖ = 1: (…, 5, 3) each."""
    t = theta / 2
    sigma = np.sin(t) ** 2
    sin_a, cos_a = np.sin(alpha), np.cos(alpha)
    b = angles.apex_distance(cos_a, ratio)
    zero, one = np.zeros_like(theta), np.ones_like(theta)
    flat = [
        (zero, zero, zero), (zero, zero, zero), (one, zero, zero), (ratio, zero, zero),
        (b * cos_a, zero, b * sin_a),
    ]  # fmt: skip
    reach = np.sqrt(np.clip(b * b - sigma, 0, None))
    deployed = [
        (zero, -np.sin(t), zero), (zero, np.sin(t), zero), (np.cos(t), zero, zero),
        (dart, zero, zero), (reach * cos_a, zero, reach * sin_a),
    ]  # fmt: skip
    return tuple(np.stack([np.stack(p, -1) for p in s], -2) for s in (flat, deployed))


_SUBUNIT = ("A_left", "A_right", "B", "C", "P")
_UPPER = [INDEX[f"{name}_upper"] for name in _SUBUNIT]
_LOWER = [INDEX[f"{name}_lower"] for name in _SUBUNIT]


def _interleave(upper: NDArray, lower: NDArray) -> NDArray:
    points = np.empty((*upper.shape[:-2], len(VERTICES), 3))
    points[..., _UPPER, :] = upper
    points[..., _LOWER, :] = lower
    return points


def _with_lower(upper: NDArray, mirror: NDArray) -> NDArray:
    return _interleave(upper, upper * mirror)


def _check_lengths(edge_length: float, strip_height: float) -> None:
    require(
        np.isfinite(edge_length) & (np.asarray(edge_length) > 0),
        "{EdgeLength} ‖AB‖ is {value:.6g}: set it to a length in mm above 0.",
        edge_length,
        parameter="EdgeLength",
    )
    require(
        np.isfinite(strip_height) & (np.asarray(strip_height) > 0),
        "Strip height h is {value:.6g}: set {HeightRatio} ‖AB‖/h to a number above 0.",
        strip_height,
        parameter="HeightRatio",
    )
